#include "host/commands/export_option.hpp"

#include <algorithm>
#include <chrono>

#include "host/base/numbers.hpp"
#include "host/base/partial_file.hpp"
#include "host/formats/export/export_errors.hpp"

namespace brdftab {
namespace {

// These files are made whole in memory, about 150 bytes a sample.
constexpr std::size_t most_samples = 20'000'000;
constexpr const char* shared_group = "Files for simulators";

std::string group_of(const ExportFormat& format) {
  return fmt::format("--format {}, for {}", format.traits().name, format.traits().consumer);
}

}  // namespace

void ExportOption::add(CLI::App& parser) {
  parser
      .add_option("--wavelength", wavelength_nm_,
                  "Only the band at this wavelength, nm, of a material that has several; formats that hold "
                  "one band need it")
      ->group(shared_group);
  parser.add_option("--illuminant", illuminant_, "For colours from bands: D65 (default), or E: equal energy")
      ->check(CLI::IsMember(std::vector<std::string>(illuminant_names.begin(), illuminant_names.end())))
      ->group(shared_group);
  for (const auto& format : formats_) {
    parser.option_defaults()->group(group_of(*format));
    format->add_options(parser);
  }
}

void ExportOption::check(const CLI::App& parser, const ExportFormat* chosen) const {
  const auto refuse = [&](const CLI::Option* option, std::string_view belongs) {
    if (option->count() > 0)
      throw BadInput("{} is for {}; the file is {}", option->get_name(), belongs,
                     chosen ? chosen->traits().name : "a dense table");
  };
  for (const CLI::Option* option : parser.get_options()) {
    if (chosen && option->get_group() == dense_group) refuse(option, "dense tables, hdf5 and exr");
    if (!chosen && option->get_group() == shared_group) refuse(option, "simulators' files");
    if (chosen && !chosen->traits().takes_axes && option->get_group() == axes_group)
      refuse(option, "formats whose axes are free");
    for (const auto& format : formats_)
      if (format.get() != chosen && option->get_group() == group_of(*format))
        refuse(option, format->traits().name);
  }
}

Material ExportOption::material_for(const ExportFormat& format, const MaterialOutput& output,
                                    const Grid& grid) const {
  const Material material = wavelength_nm_ ? output.material.at_wavelength(*wavelength_nm_) : output.material;
  if (!format.traits().holds_bands && material.bands().size() > 1)
    throw BadInput("{}: has {} bands, and {} holds one: --wavelength chooses it", output.input,
                   material.bands().size(), format.traits().name);
  const std::size_t samples = grid.directions() * material.bands().size();
  if (format.traits().takes_axes && samples > most_samples)
    throw BadInput(
        "{}: the axes have {} samples, and {} takes at most {}: coarser axes, --wavelength, or hdf5",
        output.input, samples, format.traits().name, most_samples);
  return material;
}

void ExportOption::write(const Engine& engine, const ExportFormat& format, const Material& material,
                         const Grid& grid, const std::filesystem::path& target, const std::string& history,
                         bool force, const CommonOptions& common) const {
  const auto start = std::chrono::steady_clock::now();
  const bool is_d65 = illuminant_ == name_of(Illuminant::d65);
  const ExportModel source(
      engine, material,
      {.grid = grid, .illuminant = is_d65 ? Illuminant::d65 : Illuminant::equal_energy, .history = history});
  PartialFile file(target, force);
  const auto notes = format.write(file.path(), source);
  const auto table = format.read(file.path());
  std::string consumer;
  if (!common.quiet) {
    const ReadExport read = read_export(*table, source, export_directions(*table, default_directions));
    consumer = summary(export_errors(read, source), format, *table);
  }
  const auto bytes = std::filesystem::file_size(file.path());
  file.commit();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
  say(common, fmt::format("{}: {}, {:.3g} MB in {:.2f} s", target.string(), format.traits().name,
                          static_cast<double>(bytes) / 1e6, seconds.count()));
  for (const auto& note : notes) say(common, note);
  say(common, consumer);
}

}  // namespace brdftab

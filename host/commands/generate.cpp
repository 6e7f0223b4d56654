#include "host/table/generate.hpp"

#include <fmt/chrono.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>

#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"
#include "host/commands/options/export_option.hpp"
#include "host/commands/options/format_choice.hpp"
#include "host/commands/options/interpolation_option.hpp"
#include "host/commands/outputs.hpp"
#include "host/compute/rounding.hpp"
#include "host/formats/export/export_model.hpp"
#include "host/formats/export/write_export.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> materials;
  std::string output;
  std::string format;
  std::optional<std::string> axes[4];
  std::string polarization = "unpolarized";
  std::string precision = "float32";
  std::optional<int> keep_bits;
  std::optional<std::string> device;
  InterpolationOption interpolation;
  FormatChoice formats;
  ExportOption exported;
  bool force = false;
};

std::vector<Polarization> polarizations(const std::string& name) {
  if (name == "s") return {Polarization::s};
  if (name == "p") return {Polarization::p};
  if (name == "all") return {Polarization::unpolarized, Polarization::s, Polarization::p};
  return {Polarization::unpolarized};
}

Grid grid_for(const Material& material, const Options& options) {
  Grid grid = material.grid();
  for (const auto& row : axis_table)
    if (const auto& text = options.axes[static_cast<std::size_t>(row.kind)])
      grid[row.kind] = parse_axis_option(row.kind, *text);
  return grid;
}

std::string history(const CommonOptions& common) {
  // A fixed epoch, as reproducible builds set it, makes the same table byte for byte.
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  const auto seconds = parse_number(epoch ? epoch : "0");
  if (!seconds || !(*seconds >= 0 && *seconds <= 253402300799.0))
    throw BadInput("SOURCE_DATE_EPOCH={}: must be seconds since 1970, before the year 10000", excerpt(epoch));
  const std::time_t now = epoch ? static_cast<std::time_t>(*seconds) : std::time(nullptr);
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ} {}", fmt::gmtime(now), common.command_line);
}

// How a table that is not plain came out.
std::string size_text(const TableStorage& storage, const Grid& grid, Precision precision,
                      const GenerateSummary& summary) {
  const std::string notes = storage_text(storage, grid, precision);
  if (notes.empty()) return {};
  return fmt::format(" as {:.3g} MB (ratio {:.2f}: {})", static_cast<double>(summary.file_bytes) / 1e6,
                     static_cast<double>(summary.bytes) / static_cast<double>(summary.file_bytes), notes);
}

ExitStatus export_materials(const Options& options, const ExportFormat& format,
                            const std::vector<MaterialOutput>& outputs, const CommonOptions& common) {
  // What a material can be refused for is refused before the first file is begun.
  std::vector<Grid> grids;
  std::vector<Material> materials;
  for (const MaterialOutput& output : outputs) {
    grids.push_back(grid_for(output.material, options));
    materials.push_back(options.exported.material_for(format, output, grids.back()));
  }
  const Device device = select_device(options.device);
  const Engine engine(device, Engine::widest(device), Precision::float32, common.watch);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const ExportModel source(
        engine, materials[k],
        {.grid = grids[k], .illuminant = options.exported.illuminant(), .history = history(common)});
    const ExportSummary summary =
        write_export(format, source, outputs[k].target, options.force, !common.quiet);
    say(common, fmt::format("{}: {}, {:.3g} MB in {:.2f} s", outputs[k].target.string(), format.traits().name,
                            static_cast<double>(summary.bytes) / 1e6, summary.seconds));
    for (const auto& note : summary.notes) say(common, note);
    say(common, summary.errors);
  }
  return ExitStatus::done;
}

ExitStatus run(const Options& options, const CLI::App& parser, const CommonOptions& common) {
  const Precision precision = options.precision == "float64" ? Precision::float64 : Precision::float32;
  if (options.keep_bits) check_keep_bits(*options.keep_bits, precision);
  options.interpolation.check();
  const Format& format =
      options.formats.find(options.format, options.output, names_folder(options.materials, options.output));
  options.exported.check(parser, format);
  options.formats.check(format);
  const DenseFormat* dense = format.as_dense();
  const bool writes_folder = dense && dense->writes_folder();
  auto outputs = plan_outputs(options.materials, options.output, writes_folder ? "" : format.traits().suffix,
                              options.force);
  if (!dense) return export_materials(options, *format.as_export(), outputs, common);
  TableStorage storage = dense->storage();
  storage.keep_bits = options.keep_bits;
  // What grids can be refused for is refused before the first table is begun.
  std::vector<Grid> grids;
  for (const MaterialOutput& output : outputs) {
    grids.push_back(grid_for(output.material, options));
    try {
      stored_grid(grids.back(), storage);
    } catch (const BadInput& refusal) {
      throw BadInput("{}: {}", output.input, refusal.what());
    }
  }
  std::vector<std::unique_ptr<Engine>> owned;
  std::vector<const Engine*> engines;
  for (const Device& device : select_devices(options.device)) {
    owned.push_back(std::make_unique<Engine>(device, Engine::widest(device), precision, common.watch));
    engines.push_back(owned.back().get());
  }
  GenerateOptions generate_options;
  generate_options.polarizations = polarizations(options.polarization);
  generate_options.storage = storage;
  generate_options.force = options.force;
  generate_options.history = history(common);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const MaterialOutput& output = outputs[k];
    Grid& grid = grids[k];
    if (options.interpolation.asked())
      generate_options.grid_choice = options.interpolation.choose(*engines.front(), output.material,
                                                                  generate_options.polarizations, grid);
    if (options.interpolation.dry_run()) continue;
    const auto summary = generate(
        engines, output.material, grid, output.target,
        [&](const fs::path& file, const TableContent& content) { return dense->create(file, content); },
        generate_options);
    const Accuracy& accuracy = summary.findings.accuracy;
    say(common,
        fmt::format(
            "{}: {} samples, {:.3g} MB{} in {:.2f} s; {}", output.target.string(), summary.samples,
            static_cast<double>(summary.bytes) / 1e6, size_text(storage, grid, precision, summary),
            summary.seconds,
            accuracy.nodes == 0
                ? "no node large enough to be checked against the scalar reference"
                : fmt::format(
                      "largest relative error at {} nodes checked against the scalar reference {:.1e}",
                      accuracy.nodes, accuracy.max_relative_error)));
    for (const auto& warning : summary.findings.energy_warnings) say(common, "warning: " + warning);
  }
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> generate_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("MATERIAL", options->materials,
                  "Material files (TOML), or tables or simulators' files, for the material inside; several "
                  "need -o FOLDER/")
      ->required();
  parser.add_option("-o,--output", options->output, "Table file, or a folder")->required();
  parser.add_option("--format", options->format,
                    fmt::format("Format, where the extension does not tell: {}", options->formats.known()));
  parser.option_defaults()->group(axes_group);
  for (const auto& row : axis_table)
    parser.add_option(option_name(row.name), options->axes[static_cast<std::size_t>(row.kind)],
                      fmt::format("{}, degrees: start:stop:step, both ends included, or angles separated by "
                                  "commas; default: the material's, or {}",
                                  row.long_name, row.default_text));
  parser.option_defaults()->group(dense_group);
  parser
      .add_option("--polarization", options->polarization, "unpolarized (default), s, p, or all: the three")
      ->check(CLI::IsMember({"unpolarized", "s", "p", "all"}));
  parser.add_option("--precision", options->precision, "Samples as float32 (default) or float64")
      ->check(CLI::IsMember({"float32", "float64"}));
  parser.add_option(
      "--keep-bits", options->keep_bits,
      "Round each sample to so many explicit mantissa bits, to nearest even: 1 to 23 for float32, to 52 for "
      "float64. Relative error at most 2^-(N+1); 12 bits (1.2e-4) compress about three times as well");
  options->interpolation.add(parser);
  options->formats.add_dense_options(parser);
  options->exported.add(parser);
  options->formats.add_export_options(parser);
  parser.option_defaults()->group("Options");
  parser.add_flag("--force", options->force, "Overwrite an existing table");
  add_device_option(parser, options->device, true);
  return [options, &parser, &common] { return run(*options, parser, common); };
}

}  // namespace brdftab

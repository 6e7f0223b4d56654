// Surface scattering distribution data, version 0.3: axes in degrees and a dense table, text or float32.
//
// Source: SsddFileFormatSpecification.md of libbsdf.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <iterator>
#include <map>
#include <set>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/export/grid_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/registry.hpp"
#include "host/model/surface_vector.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little);

class SsddFormat : public ExportFormat {
 public:
  SsddFormat()
      : ExportFormat({.name = "ssdd",
                      .consumer = "libbsdf and BSDFProcessor",
                      .extensions = {".ssdd"},
                      .suffix = ".ssdd",
                      .takes_axes = true}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "ssdd_data",
             .help = "ascii (default), or binary: float32",
             .value = &data_,
             .words = {"ascii", "binary"}}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    const Grid& grid = source.grid();
    // f is even in phi: half a turn is all of it.
    std::set<double> folded;
    for (const double phi : azimuths_away_from_surface(grid)) folded.insert(std::min(phi, 360 - phi));
    folded.insert(180);
    Directions directions;
    for (const double phi : folded)
      for (const double theta_s : grid.theta_s.nodes())
        for (const double theta_i : grid.theta_i.nodes()) directions.add(theta_i, theta_s, model_phi(0, phi));
    const auto f = source.evaluate(directions);
    const auto wavelengths = source.wavelengths_nm();

    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "VERSION 0.3\nSOFTWARE {}\n", program_version);
    for (const auto& line : description_lines(source, ExportChannels::bands))
      fmt::format_to(out, "# {}\n", line);
    fmt::format_to(out, "\nDATA_TYPE brdf\n");
    if (wavelengths.empty())
      fmt::format_to(out, "COLOR_MODEL monochrome\n");
    else
      fmt::format_to(out, "COLOR_MODEL spectrum\nWAVELENGTH_LIST {}\n", fmt::join(wavelengths, " "));
    fmt::format_to(out, "PARAM_TYPE spherical_coordinate_system\nREDUCTION_TYPE bilateral_symmetry\n");
    fmt::format_to(out, "PARAM0_LIST {}\nPARAM2_LIST {}\nPARAM3_LIST {}\nSOURCE_TYPE generated\nDATA {}\n",
                   fmt::join(grid.theta_i.nodes(), " "), fmt::join(grid.theta_s.nodes(), " "),
                   fmt::join(folded, " "), data_);
    if (data_ == "binary") {
      std::vector<float> values;
      for (std::size_t k = 0; k < directions.size(); ++k)
        for (const auto& band : f) values.push_back(static_cast<float>(band[k]));
      if (begins_a_comment(values))
        throw BadInput(GivenValue{"ssdd_data", data_},
                       "these samples begin as a comment does, which readers skip; take ascii");
      text.append(
          std::string_view(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)));
    } else {
      for (std::size_t k = 0; k < directions.size(); ++k)
        for (std::size_t band = 0; band < f.size(); ++band)
          fmt::format_to(out, "{:.9g}{}", f[band][k], band + 1 < f.size() ? ' ' : '\n');
    }
    write_whole(file, {text.data(), text.size()});
    return {};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with("VERSION ");
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    const std::string bytes = read_whole(file);
    std::map<std::string, std::string, std::less<>> entries;
    Description description;
    std::string_view rest = bytes;
    std::size_t line = 0;
    const auto where = [&] { return fmt::format("{}:{}", file.string(), line); };
    const auto next_line = [&] {
      const auto end = rest.find('\n');
      if (end == rest.npos) throw BadInput("{}: ends too early", where());
      const std::string_view found = rest.substr(0, end);
      rest.remove_prefix(end + 1);
      ++line;
      return found;
    };
    while (!entries.contains("DATA")) {
      const std::string_view entry = trimmed(next_line());
      if (entry.starts_with('#')) {
        description.read(entry.substr(1));
      } else if (!entry.empty()) {
        const auto blank = std::min(entry.find(' '), entry.size());
        entries.insert_or_assign(std::string(entry.substr(0, blank)),
                                 std::string(trimmed(entry.substr(blank))));
      }
    }
    const auto expect = [&](std::string_view name, std::string_view wanted) {
      const auto found = entries.find(name);
      if (found == entries.end() || found->second != wanted)
        throw BadInput("{}: {} {}: must be {}", where(), name,
                       found == entries.end() ? "is missing" : excerpt(found->second), wanted);
    };
    expect("DATA_TYPE", "brdf");
    expect("PARAM_TYPE", "spherical_coordinate_system");
    const auto list = [&](std::string_view name) {
      const auto found = entries.find(name);
      return found == entries.end() ? std::vector<double>{} : numbers(found->second, where());
    };
    if (entries.contains("PARAM1_LIST") && list("PARAM1_LIST").size() > 1)
      throw BadInput("{}: PARAM1_LIST: only isotropic files are read", where());
    const auto theta_i = list("PARAM0_LIST"), theta_s = list("PARAM2_LIST"), phi = list("PARAM3_LIST");
    const auto wavelengths = list("WAVELENGTH_LIST");
    const std::size_t channels = entries["COLOR_MODEL"] == "spectrum" ? wavelengths.size() : 1;
    const std::size_t nodes = theta_i.size() * theta_s.size() * phi.size();
    if (nodes == 0 || channels == 0) throw BadInput("{}: an axis of the table is missing", where());

    std::vector<double> samples;
    if (entries["DATA"] == "binary") {
      if (rest.size() < nodes * channels * sizeof(float))
        throw BadInput("{}: ends before its {} samples", file.string(), nodes * channels);
      std::vector<float> values(nodes * channels);
      std::memcpy(values.data(), rest.data(), values.size() * sizeof(float));
      samples.assign(values.begin(), values.end());
    } else {
      while (samples.size() < nodes * channels) {
        const std::string_view row = next_line();
        if (trimmed(row).empty() || trimmed(row).starts_with('#')) continue;
        const auto values = numbers(row, where());
        if (values.size() != channels)
          throw BadInput("{}: has {} values; {} channels have as many", where(), values.size(), channels);
        samples.insert(samples.end(), values.begin(), values.end());
      }
    }
    // [phi][theta_s][theta_i][channel] to [channel][theta_i][1][theta_s][phi].
    std::vector<std::vector<double>> values(channels, std::vector<double>(nodes));
    for (std::size_t q = 0; q < phi.size(); ++q)
      for (std::size_t s = 0; s < theta_s.size(); ++s)
        for (std::size_t i = 0; i < theta_i.size(); ++i)
          for (std::size_t c = 0; c < channels; ++c)
            values[c][(i * theta_s.size() + s) * phi.size() + q] =
                samples[((q * theta_s.size() + s) * theta_i.size() + i) * channels + c];
    // The file's azimuths are those of vectors away from the surface.
    std::vector<double> model;
    for (const double azimuth : phi) model.push_back(model_phi(0, azimuth));
    GridSamples table({theta_i, {0}, theta_s, std::move(model)}, std::move(values), file.string());
    return std::make_unique<GridReader>(std::vector{std::move(table)}, wavelengths,
                                        std::move(description.material_text),
                                        "linear interpolation between nodes, as libbsdf");
  }

 private:
  static std::vector<double> numbers(std::string_view text, const std::string& where) {
    std::vector<double> result;
    while (!(text = trimmed(text)).empty()) {
      const auto end = std::min(text.find_first_of(" \t"), text.size());
      const auto value = parse_number(text.substr(0, end));
      if (!value) throw BadInput("{}: {}: must be a number", where, excerpt(text.substr(0, end)));
      result.push_back(*value);
      text.remove_prefix(end);
    }
    return result;
  }

  // Readers look for comments after the header, also before binary samples.
  static bool begins_a_comment(const std::vector<float>& values) {
    std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    const auto first = bytes.find_first_not_of(" \t\n\v\f\r");
    return first != bytes.npos && bytes[first] == '#';
  }

  std::string data_ = "ascii";
};

}  // namespace

std::unique_ptr<Format> make_ssdd_format() { return std::make_unique<SsddFormat>(); }

}  // namespace brdftab

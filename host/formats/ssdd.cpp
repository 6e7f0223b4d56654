// Surface scattering distribution data, version 0.3, are axes in degrees and a dense table, text or float32.
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
#include "host/model/grid_index.hpp"
#include "host/model/surface_vector.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little);

// Takes a file from its beginning: the entries of a header, one a line, and then the samples.
class SsddParser {
 public:
  SsddParser(std::string bytes, std::string file)
      : bytes_(std::move(bytes)), file_(std::move(file)), rest_(bytes_) {}

  std::unique_ptr<ExportReader> parse() {
    read_header();
    expect("DATA_TYPE", "brdf");
    expect("PARAM_TYPE", "spherical_coordinate_system");
    if (list("PARAM1_LIST").size() > 1)
      throw BadInput("{}: PARAM1_LIST: only isotropic files are read", where());
    const auto theta_i = list("PARAM0_LIST"), theta_s = list("PARAM2_LIST"), phi = list("PARAM3_LIST");
    const auto wavelengths = list("WAVELENGTH_LIST");
    const std::size_t channels = entries_["COLOR_MODEL"] == "spectrum" ? wavelengths.size() : 1;
    const std::size_t nodes = theta_i.size() * theta_s.size() * phi.size();
    if (nodes == 0 || channels == 0) throw BadInput("{}: an axis of the table is missing", where());
    const auto samples =
        entries_["DATA"] == "binary" ? binary_samples(nodes * channels) : text_samples(nodes, channels);
    // The order [phi][theta_s][theta_i][channel] becomes [channel][theta_i][1][theta_s][phi].
    const GridIndex order({theta_i.size(), 1, theta_s.size(), phi.size()});
    std::vector<std::vector<double>> values(channels, std::vector<double>(nodes));
    for (std::size_t node = 0; node < nodes; ++node) {
      const auto [i, p, s, q] = order.node(node);
      for (std::size_t c = 0; c < channels; ++c)
        values[c][node] = samples[((q * theta_s.size() + s) * theta_i.size() + i) * channels + c];
    }
    // The file's azimuths are those of vectors away from the surface.
    std::vector<double> model;
    for (const double azimuth : phi) model.push_back(model_phi(0, azimuth));
    GridSamples table({theta_i, {0}, theta_s, std::move(model)}, std::move(values), file_);
    return std::make_unique<GridReader>(std::vector{std::move(table)}, wavelengths,
                                        std::move(description_.material_text),
                                        "linear interpolation between nodes, as libbsdf");
  }

 private:
  std::string where() const { return fmt::format("{}:{}", file_, line_); }

  std::string_view next_line() {
    const auto end = rest_.find('\n');
    if (end == rest_.npos) throw BadInput("{}: ends too early", where());
    const std::string_view found = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    ++line_;
    return found;
  }

  void read_header() {
    while (!entries_.contains("DATA")) {
      const std::string_view entry = trimmed(next_line());
      if (entry.starts_with('#')) {
        description_.read(entry.substr(1));
      } else if (!entry.empty()) {
        const auto blank = std::min(entry.find(' '), entry.size());
        entries_.insert_or_assign(std::string(entry.substr(0, blank)),
                                  std::string(trimmed(entry.substr(blank))));
      }
    }
  }

  void expect(std::string_view name, std::string_view wanted) const {
    const auto found = entries_.find(name);
    if (found == entries_.end() || found->second != wanted)
      throw BadInput("{}: {} {}: must be {}", where(), name,
                     found == entries_.end() ? "is missing" : excerpt(found->second), wanted);
  }

  // The list is empty where the header has no such entry.
  std::vector<double> list(std::string_view name) const {
    const auto found = entries_.find(name);
    return found == entries_.end() ? std::vector<double>{} : numbers(found->second);
  }

  std::vector<double> binary_samples(std::size_t count) const {
    if (rest_.size() < count * sizeof(float)) throw BadInput("{}: ends before its {} samples", file_, count);
    std::vector<float> values(count);
    std::memcpy(values.data(), rest_.data(), count * sizeof(float));
    return {values.begin(), values.end()};
  }

  std::vector<double> text_samples(std::size_t nodes, std::size_t channels) {
    std::vector<double> samples;
    while (samples.size() < nodes * channels) {
      const std::string_view row = next_line();
      if (trimmed(row).empty() || trimmed(row).starts_with('#')) continue;
      const auto values = numbers(row);
      if (values.size() != channels)
        throw BadInput("{}: has {} values; {} channels have as many", where(), values.size(), channels);
      samples.insert(samples.end(), values.begin(), values.end());
    }
    return samples;
  }

  std::vector<double> numbers(std::string_view text) const {
    std::vector<double> result;
    while (!(text = trimmed(text)).empty()) {
      const auto end = std::min(text.find_first_of(" \t"), text.size());
      const auto value = parse_number(text.substr(0, end));
      if (!value) throw BadInput("{}: {}: must be a number", where(), excerpt(text.substr(0, end)));
      result.push_back(*value);
      text.remove_prefix(end);
    }
    return result;
  }

  const std::string bytes_, file_;
  std::string_view rest_;
  std::size_t line_ = 0;
  std::map<std::string, std::string, std::less<>> entries_;
  Description description_;
};

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
    return SsddParser(read_whole(file), file.string()).parse();
  }

 private:
  // Readers look for comments after the header, even before binary samples.
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

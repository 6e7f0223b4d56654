// ASTM E1392 text as Cornell writes it has a row for each pair of directions, in radians, both away from the
// surface.
#include <fstream>
#include <iterator>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/export/grid_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/registry.hpp"
#include "host/formats/text/alta_astm_measurement.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

constexpr std::string_view comment = "COMMENT ";

class AstmFormat : public ExportFormat {
 public:
  AstmFormat()
      : ExportFormat({.name = "astm",
                      .consumer = "libbsdf, ALTA and other readers of Cornell's ASTM E1392 text",
                      .extensions = {".astm"},
                      .suffix = ".astm",
                      .takes_axes = true,
                      .measurement = MeasurementReader{
                          .extensions = {".astm"}, .read = read_astm_measurement, .lists_grids = true}}) {}

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    const Grid& grid = source.grid();
    const auto azimuths = azimuths_away_from_surface(grid);
    Directions directions;
    for (const double theta_i : grid.theta_i.nodes())
      for (const double theta_s : grid.theta_s.nodes())
        for (const double phi : azimuths) directions.add(theta_i, theta_s, model_phi(0, phi));
    const auto f = source.evaluate(directions);
    std::vector<std::string> channels;
    for (const double wavelength : source.wavelengths_nm())
      channels.push_back(fmt::format("{}nm", wavelength));
    if (channels.empty()) channels.emplace_back("brdf");

    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    for (const auto& line : description_lines(source, ExportChannels::bands))
      fmt::format_to(out, "{}{}\n", comment, line);
    fmt::format_to(out, "NUM_POINTS {}\nVARS theta_i,phi_i,theta_s,phi_s,{}\n", directions.size(),
                   fmt::join(channels, ","));
    std::vector<std::string> phi_texts;
    for (const double phi : azimuths) phi_texts.push_back(fmt::format("{}", radians(phi)));
    std::size_t k = 0;
    for (const double theta_i : grid.theta_i.nodes())
      for (const double theta_s : grid.theta_s.nodes()) {
        const std::string angles = fmt::format("{},0,{},", radians(theta_i), radians(theta_s));
        for (const auto& phi : phi_texts) {
          fmt::format_to(out, "{}{}", angles, phi);
          for (const auto& channel : f) fmt::format_to(out, ",{:.9g}", channel[k]);
          text.push_back('\n');
          ++k;
        }
      }
    write_whole(file, {text.data(), text.size()});
    return {};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with(comment) || beginning.starts_with("NUM_POINTS") ||
           beginning.find("\nVARS theta_i,phi_i,theta_s,phi_s,") != beginning.npos;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    std::ifstream in = open_file(file);
    Description description;
    for (std::string line; std::getline(in, line) && !line.starts_with("VARS");)
      if (line.starts_with(comment)) description.read(std::string_view(line).substr(comment.size()));
    in.seekg(0);
    const Measurement rows = read_astm_measurement(in, file.string());
    const std::size_t channels = rows.channels.size();
    std::vector<std::vector<double>> columns(4 + channels);
    std::vector<double> wavelengths;
    for (std::size_t c = 0; c < channels; ++c) {
      if (const auto wavelength = rows.wavelength_nm(c)) wavelengths.push_back(*wavelength);
      for (const MeasuredSample& sample : rows.samples) {
        if (sample.channel != c) continue;
        columns[4 + c].push_back(sample.brdf);
        if (c > 0) continue;
        columns[0].push_back(sample.pair.theta_i);
        columns[1].push_back(0);
        columns[2].push_back(sample.pair.theta_s);
        columns[3].push_back(sample.pair.phi);
      }
    }
    return std::make_unique<GridReader>(std::vector{GridSamples::from_rows(columns, file.string())},
                                        std::move(wavelengths), std::move(description.material_text),
                                        "linear interpolation between nodes, as libbsdf");
  }
};

}  // namespace

std::unique_ptr<Format> make_astm_format() { return std::make_unique<AstmFormat>(); }

}  // namespace brdftab

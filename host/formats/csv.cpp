// A long table of comma-separated values, for whatever reads text: a row for each pair of directions.
#include "host/csv.hpp"

#include <fstream>
#include <iterator>

#include "host/error.hpp"
#include "host/export_text.hpp"
#include "host/formats/formats.hpp"
#include "host/formats/grid_table.hpp"
#include "host/grid_samples.hpp"
#include "host/numbers.hpp"
#include "host/table_content.hpp"
#include "host/whole_file.hpp"

namespace brdftab {
namespace {

constexpr std::string_view first_line = "# A row for each pair of directions; f = brdf in 1/sr";
constexpr std::string_view columns = "theta_i_deg,phi_i_deg,theta_s_deg,phi_s_deg,brdf_s,brdf_p,brdf";

class CsvFormat : public ExportFormat {
 public:
  CsvFormat()
      : ExportFormat({.name = "csv",
                      .consumer = "anything that reads text; a row for each pair of directions",
                      .extensions = {".csv"},
                      .suffix = ".csv",
                      .takes_axes = true,
                      .holds_polarization = true}) {}

  void add_options(CLI::App& parser) override {
    parser.add_option("--csv-digits", digits_, "Significant digits of f, 1 to 17; default 9")->check(CLI::Range(1, 17));
  }

  std::vector<std::string> write(const std::filesystem::path& file, const ExportSource& source) const override {
    const Grid& grid = source.grid();
    const Directions directions = directions_of(grid);
    const auto s = source.evaluate(directions, Polarization::s);
    const auto p = source.evaluate(directions, Polarization::p);
    const auto wavelengths = source.wavelengths_nm();
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{}\n", first_line);
    for (const auto& line : description_lines(source, ExportChannels::bands)) fmt::format_to(out, "# {}\n", line);
    fmt::format_to(out, "# {}\n{}{}\n", azimuth_convention, wavelengths.empty() ? "" : "wavelength_nm,", columns);
    for (std::size_t band = 0; band < s.size(); ++band) {
      const std::string first = wavelengths.empty() ? "" : fmt::format("{},", wavelengths[band]);
      std::size_t k = 0;
      for (const double theta_i : grid.theta_i.nodes())
        for (const double phi_i : grid.phi_i.nodes())
          for (const double theta_s : grid.theta_s.nodes()) {
            const std::string angles = fmt::format("{}{},{},{},", first, theta_i, phi_i, theta_s);
            for (const double phi_s : grid.phi_s.nodes()) {
              fmt::format_to(out, "{}{},{:.{}g},{:.{}g},{:.{}g}\n", angles, phi_s, s[band][k], digits_, p[band][k], digits_,
                             0.5 * (s[band][k] + p[band][k]), digits_);
              ++k;
            }
          }
    }
    write_whole(file, {text.data(), text.size()});
    return {};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with(first_line) || beginning.find(columns) != beginning.npos;
  }

  std::unique_ptr<ExportedTable> read(const std::filesystem::path& file) const override {
    std::ifstream in(file);
    if (!in) throw FileError("{}: cannot be opened", file.string());
    Description description;
    for (std::string line; in.peek() == '#' && std::getline(in, line);) description.read(std::string_view(line).substr(1));
    Csv csv(in, file.string(), columns);
    std::vector<std::size_t> wanted;
    for (const auto name : {"theta_i_deg", "phi_i_deg", "theta_s_deg", "phi_s_deg", "brdf"}) {
      const auto column = csv.column(name);
      if (!column) throw BadInput("{}: has no column {}", csv.where(), name);
      wanted.push_back(*column);
    }
    const auto wavelength = csv.column("wavelength_nm");
    std::vector<double> wavelengths;
    std::vector<std::vector<std::vector<double>>> bands;  // [band][column][row]
    std::string current;
    while (const auto* cells = csv.next()) {
      const std::string_view name = wavelength ? (*cells)[*wavelength] : "";
      if (bands.empty() || name != current) {
        current = name;
        bands.emplace_back(wanted.size());
      }
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        const auto value = parse_number((*cells)[wanted[k]]);
        if (!value) throw BadInput("{}: {}: must be a number", csv.where(), excerpt((*cells)[wanted[k]]));
        bands.back()[k].push_back(*value);
      }
    }
    if (bands.empty()) throw BadInput("{}: has no rows", csv.where());
    std::vector<GridSamples> samples;
    for (const auto& band : bands) samples.push_back(GridSamples::from_rows(band, file.string()));
    return std::make_unique<GridTable>(std::move(samples), std::move(description.wavelengths_nm),
                                       std::move(description.material_text));
  }

 private:
  int digits_ = 9;
};

}  // namespace

std::unique_ptr<ExportFormat> make_csv_format() { return std::make_unique<CsvFormat>(); }

}  // namespace brdftab

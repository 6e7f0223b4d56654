// A long table of comma-separated values, for whatever reads text, has a row for each pair of directions.
#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>

#include "host/base/csv.hpp"
#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/export/grid_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/registry.hpp"
#include "host/formats/text/csv_measurement.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

constexpr std::string_view first_line = "# A row for each pair of directions; f = brdf in 1/sr";
constexpr std::string_view columns = "theta_i_deg,phi_i_deg,theta_s_deg,phi_s_deg,brdf_s,brdf_p,brdf";

// These columns are read, the angles first; the last two may be absent.
constexpr std::array<std::string_view, 7> names{"theta_i_deg", "phi_i_deg", "theta_s_deg", "phi_s_deg",
                                                "brdf",        "brdf_s",    "brdf_p"};
constexpr std::size_t angle_columns = 4, needed = 5;

// Counts the significant digits of a number as it is written.
int digits_of(std::string_view number) {
  const std::string_view mantissa = number.substr(0, number.find_first_of("eE"));
  const auto first = mantissa.find_first_of("123456789");
  if (first == mantissa.npos) return 0;
  return static_cast<int>(std::count_if(mantissa.begin() + static_cast<std::ptrdiff_t>(first), mantissa.end(),
                                        [](char c) { return c >= '0' && c <= '9'; }));
}

class CsvFormat : public ExportFormat {
 public:
  CsvFormat()
      : ExportFormat({.name = "csv",
                      .consumer = "anything that reads text; a row for each pair of directions",
                      .extensions = {".csv"},
                      .suffix = ".csv",
                      .takes_axes = true,
                      .holds_polarization = true,
                      .measurement = MeasurementReader{
                          .extensions = {".csv"}, .read = read_csv_measurement, .tells_light = true}}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "csv_digits",
             .help = "Significant digits of f, 1 to 17; default 9",
             .value = &digits_,
             .range = {{1, 17}}}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    const Grid& grid = source.grid();
    const Directions directions = directions_of(grid);
    const auto s = source.evaluate(directions, Polarization::s);
    const auto p = source.evaluate(directions, Polarization::p);
    const auto wavelengths = source.wavelengths_nm();
    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{}\n", first_line);
    for (const auto& line : description_lines(source, ExportChannels::bands))
      fmt::format_to(out, "# {}\n", line);
    fmt::format_to(out, "# {}\n{}{}\n", azimuth_convention, wavelengths.empty() ? "" : "wavelength_nm,",
                   columns);
    for (std::size_t band = 0; band < s.size(); ++band) {
      const std::string first = wavelengths.empty() ? "" : fmt::format("{},", wavelengths[band]);
      std::size_t k = 0;
      for (const double theta_i : grid.theta_i.nodes())
        for (const double phi_i : grid.phi_i.nodes())
          for (const double theta_s : grid.theta_s.nodes()) {
            const std::string angles = fmt::format("{}{},{},{},", first, theta_i, phi_i, theta_s);
            for (const double phi_s : grid.phi_s.nodes()) {
              fmt::format_to(out, "{}{},{:.{}g},{:.{}g},{:.{}g}\n", angles, phi_s, s[band][k], digits_,
                             p[band][k], digits_, 0.5 * (s[band][k] + p[band][k]), digits_);
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

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    std::ifstream in = open_file(file);
    Description description;
    for (std::string line; in.peek() == '#' && std::getline(in, line);)
      description.read(std::string_view(line).substr(1));
    Csv csv(in, file.string(), columns);
    std::vector<std::size_t> wanted;
    for (const auto name : names) {
      const auto column = csv.column(name);
      if (!column && wanted.size() < needed) throw BadInput("{}: has no column {}", csv.where(), name);
      if (column) wanted.push_back(*column);
    }
    const bool is_polarized = wanted.size() == names.size();
    if (!is_polarized) wanted.resize(needed);
    const auto wavelength = csv.column("wavelength_nm");
    std::vector<double> wavelengths;
    std::vector<std::vector<std::vector<double>>> bands;  // [band][column][row]
    std::string current;
    int digits = 0;
    while (const auto* cells = csv.next()) {
      const std::string_view name = wavelength ? (*cells)[*wavelength] : "";
      if (bands.empty() || name != current) {
        current = name;
        bands.emplace_back(wanted.size());
        if (wavelength) wavelengths.push_back(number(name, csv));
      }
      for (std::size_t k = 0; k < wanted.size(); ++k) {
        const std::string_view cell = (*cells)[wanted[k]];
        bands.back()[k].push_back(number(cell, csv));
        if (k >= angle_columns) digits = std::max(digits, digits_of(cell));
      }
    }
    if (bands.empty()) throw BadInput("{}: has no rows", csv.where());
    const auto samples = [&](std::size_t column) {
      std::vector<GridSamples> result;
      for (const auto& band : bands) {
        std::vector<std::vector<double>> rows(band.begin(), band.begin() + angle_columns);
        rows.push_back(band[column]);
        result.push_back(GridSamples::from_rows(rows, file.string()));
      }
      return result;
    };
    auto table = std::make_unique<GridReader>(samples(angle_columns), std::move(wavelengths),
                                              std::move(description.material_text));
    table->set_digits(digits);
    if (is_polarized) {
      table->add_polarization(Polarization::s, samples(angle_columns + 1));
      table->add_polarization(Polarization::p, samples(angle_columns + 2));
    }
    return table;
  }

 private:
  static double number(std::string_view cell, const Csv& csv) {
    const auto value = parse_number(cell);
    if (!value) throw BadInput("{}: {}: must be a number", csv.where(), excerpt(cell));
    return *value;
  }

  int digits_ = 9;
};

}  // namespace

std::unique_ptr<Format> make_csv_format() { return std::make_unique<CsvFormat>(); }

}  // namespace brdftab

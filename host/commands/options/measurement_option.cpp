#include "host/commands/options/measurement_option.hpp"

#include <fmt/format.h>

#include "host/formats/read_measurement.hpp"

namespace brdftab {
namespace {

template <class Table>
std::vector<std::string> names_of(const Table& table) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(row.name);
  return names;
}

}  // namespace

void MeasurementOption::add(CLI::App& parser) {
  std::string kinds;
  for (const ValueKindRow& row : value_kind_table) kinds += fmt::format("; {}: {}", row.name, row.meaning);
  all_ = {
      parser.add_option("--format", options_.format, "Of the measurement; default: by its extension")
          ->check(CLI::IsMember(measurement_formats())),
      parser
          .add_option("--angles", angles_,
                      "Unit of the measurement's angles; default: degrees in csv and zemax, radians in alta "
                      "and astm. azimuth-radians: theta in degrees, phi in radians")
          ->check(CLI::IsMember(names_of(angle_units))),
      parser
          .add_option("--values", values_,
                      fmt::format("What the measurement's values are; default: brdf, with a warning where "
                                  "they look unlike it{}",
                                  kinds))
          ->check(CLI::IsMember(names_of(value_kind_table))),
      parser
          .add_option("--scale", options_.scale,
                      "Further factor from the measurement's values to f in 1/sr; default 1")
          ->check(CLI::PositiveNumber),
      parser
          .add_option("--wavelength-unit", wavelength_unit_,
                      "Of the measurement's wavelengths, where neither they nor their column (wavelength_um) "
                      "say it; default nm, with a warning where that is no light's")
          ->check(CLI::IsMember(names_of(wavelength_units))),
      parser
          .add_option("--incidence-width", options_.incidence_width,
                      "Samples whose theta_i lie closer together are one angle of incidence, degrees; "
                      "default 0.25; 0: equal numbers")
          ->check(CLI::Range(0., 90.)),
      parser.add_flag("--flip-azimuth", options_.flip_azimuth,
                      "The measurement counts azimuth from the backward side"),
  };
}

MeasurementOptions MeasurementOption::options() const {
  MeasurementOptions options = options_;
  options.angles = parse_angle_unit(angles_);
  options.values = parse_value_kind(values_);
  options.wavelength_unit = parse_wavelength_unit(wavelength_unit_);
  return options;
}

std::vector<std::string> MeasurementOption::given() const {
  std::vector<std::string> names;
  for (const CLI::Option* option : all_)
    if (option->count() > 0) names.push_back(option->get_name());
  return names;
}

}  // namespace brdftab

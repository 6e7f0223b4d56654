#include "host/formats/text/csv_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/direction_list.hpp"
#include "host/model/measurement/measured_light.hpp"

namespace brdftab {
namespace {

double number(const Csv& csv, std::string_view cell, std::string_view column, std::string_view allowed) {
  const auto value = parse_number(cell);
  if (!value || std::isinf(*value))
    throw BadInput("{}: {} = {}: must be {}", csv.where(), column, excerpt(cell), allowed);
  return *value;
}

// Turns the angles into degrees. Gives false where theta is a quarter of a turn, but for its digits: the
// model has no value there.
bool take_angles(DirectionPair& pair, const AngleUnit& unit, const Csv& csv) {
  constexpr double beyond_rim = 0.02;
  pair.theta_i = in_degrees(pair.theta_i, unit.theta);
  pair.theta_s = in_degrees(pair.theta_s, unit.theta);
  pair.phi = in_degrees(pair.phi, unit.phi);
  const double theta = std::max(pair.theta_i, pair.model_theta_s());
  if (theta > 90 + beyond_rim)
    throw BadInput("{}: theta = {} degrees, by `angles` {}: must be below 90", csv.where(), shortest(theta),
                   unit.name);
  return theta < 90;
}

void warn_of_radians(Measurement& measurement) {
  std::vector<double> theta_i, theta_s, phi;
  for (const auto& sample : measurement.samples) {
    theta_i.push_back(sample.pair.theta_i);
    theta_s.push_back(sample.pair.theta_s);
    phi.push_back(sample.pair.phi);
  }
  std::string doubt = doubt_of_degrees(theta_i, theta_s, phi);
  if (!doubt.empty()) measurement.warnings.push_back(std::move(doubt));
}

// The columns of f in one light, and of its uncertainty.
struct BrdfColumn {
  Polarization light;
  std::size_t brdf;
  std::optional<std::size_t> sigma;
};

std::optional<std::size_t> column_of(const Csv& csv, const std::string& name) {
  // `evaluate` writes brdf: the model's own values are a measurement too.
  const auto column = csv.column(name + "_per_sr");
  return column ? column : csv.column(name);
}

std::vector<BrdfColumn> brdf_columns(const Csv& csv) {
  std::vector<BrdfColumn> columns;
  for (const auto& [light, suffix] :
       {std::pair{Polarization::unpolarized, ""}, {Polarization::s, "_s"}, {Polarization::p, "_p"}}) {
    const auto brdf = column_of(csv, std::string(brdf_name(light)));
    if (!brdf) continue;
    const auto own = column_of(csv, std::string("sigma") + suffix);
    columns.push_back({light, *brdf, own ? own : column_of(csv, "sigma")});
  }
  return columns;
}

}  // namespace

Measurement read_csv_measurement(std::istream& in, const std::string& source,
                                 const MeasurementOptions& options) {
  constexpr std::string_view wanted = "theta_i_deg, theta_s_deg, phi_deg and brdf_per_sr";
  Csv csv(in, source, wanted);
  const DirectionColumns directions(csv);
  const std::vector<BrdfColumn> brdf = brdf_columns(csv);
  if (brdf.empty())
    throw BadInput("{}: the column brdf_per_sr is missing; a header names {}", csv.where(), wanted);
  const auto micrometres = csv.column("wavelength_um");
  if (micrometres && csv.column("wavelength_nm"))
    throw BadInput("{}: wavelength_nm and wavelength_um: one of them must do", csv.where());
  const auto channel = micrometres                   ? micrometres
                       : csv.column("wavelength_nm") ? csv.column("wavelength_nm")
                                                     : csv.column("channel");
  std::size_t at_rim = 0;
  Measurement measurement;
  measurement.source = source;
  while (const auto* cells = csv.next()) {
    DirectionPair pair = directions.read(csv, *cells);
    const bool is_at_rim = options.angles && !take_angles(pair, *options.angles, csv);
    std::string name(channel ? (*cells)[*channel] : std::string_view{});
    if (micrometres && parse_number(name)) name += "um";
    auto& names = measurement.channels;
    const auto at = std::find(names.begin(), names.end(), name);
    const auto index = static_cast<std::size_t>(at - names.begin());
    if (at == names.end()) names.push_back(name);
    at_rim += is_at_rim;
    for (const BrdfColumn& column : brdf) {
      MeasuredSample sample{.pair = pair, .brdf = 0, .channel = index, .share_s = share_s(column.light)};
      sample.brdf = number(csv, (*cells)[column.brdf], csv.name(column.brdf), "a number in 1/sr");
      if (column.sigma) {
        sample.sigma =
            number(csv, (*cells)[*column.sigma], csv.name(*column.sigma), "a number above 0, in 1/sr");
        if (!(sample.sigma > 0))
          throw BadInput("{}: {} = {}: must be a number above 0, in 1/sr", csv.where(),
                         csv.name(*column.sigma), excerpt((*cells)[*column.sigma]));
      }
      if (!is_at_rim) measurement.samples.push_back(sample);
    }
  }
  if (at_rim > 0)
    measurement.warnings.push_back(fmt::format("{} samples at theta = 90 degrees: set aside", at_rim));
  if (!options.angles) warn_of_radians(measurement);
  return measurement;
}

}  // namespace brdftab

#include <algorithm>
#include <cmath>

#include "host/error.hpp"
#include "host/measurement.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

double number(const Csv& csv, std::string_view cell, std::string_view column, std::string_view allowed) {
  const auto value = parse_number(cell);
  if (!value || std::isinf(*value)) throw BadInput("{}: {} = {}: must be {}", csv.where(), column, excerpt(cell), allowed);
  return *value;
}

}  // namespace

Measurement read_csv_measurement(std::istream& in, const std::string& source) {
  constexpr std::string_view wanted = "theta_i_deg, theta_s_deg, phi_deg and brdf_per_sr";
  Csv csv(in, source, wanted);
  const DirectionColumns directions(csv);
  // `evaluate` writes brdf: the model's own values are a measurement too.
  const auto brdf = csv.column("brdf_per_sr") ? csv.column("brdf_per_sr") : csv.column("brdf");
  if (!brdf) throw BadInput("{}: the column brdf_per_sr is missing; a header names {}", csv.where(), wanted);
  const auto sigma = csv.column("sigma");
  const auto channel = csv.column("wavelength_nm") ? csv.column("wavelength_nm") : csv.column("channel");
  Measurement measurement;
  measurement.source = source;
  while (const auto* cells = csv.next()) {
    MeasuredSample sample{.pair = directions.read(csv, *cells), .brdf = 0};
    sample.brdf = number(csv, (*cells)[*brdf], "brdf_per_sr", "a number in 1/sr");
    if (sigma) {
      sample.sigma = number(csv, (*cells)[*sigma], "sigma", "a number above 0, in 1/sr");
      if (!(sample.sigma > 0))
        throw BadInput("{}: sigma = {}: must be a number above 0, in 1/sr", csv.where(), excerpt((*cells)[*sigma]));
    }
    const std::string name(channel ? (*cells)[*channel] : std::string_view{});
    auto& names = measurement.channels;
    const auto at = std::find(names.begin(), names.end(), name);
    sample.channel = static_cast<std::size_t>(at - names.begin());
    if (at == names.end()) names.push_back(name);
    measurement.samples.push_back(sample);
  }
  return measurement;
}

}  // namespace brdftab

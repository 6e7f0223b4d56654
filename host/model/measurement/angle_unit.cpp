#include "host/model/measurement/angle_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brdftab {
namespace {

// So far pi in four digits may be off.
constexpr double rounding = 1 + 1e-4;
constexpr double turn = 2 * std::numbers::pi;

double largest(std::span<const double> angles) {
  double result = 0;
  for (const double angle : angles) result = std::max(result, std::abs(angle));
  return result;
}

bool are_multiples(std::span<const double> angles, double factor, double step, double tolerance) {
  return std::all_of(angles.begin(), angles.end(), [&](double angle) {
    return std::abs(std::remainder(angle * factor, step)) <= tolerance;
  });
}

// People write degrees as such multiples.
bool are_round(std::span<const double> angles) { return are_multiples(angles, 1, 0.01, 1e-9); }

}  // namespace

std::optional<AngleUnit> parse_angle_unit(std::string_view name) {
  const auto row = std::find_if(angle_units.begin(), angle_units.end(),
                                [&](const auto& unit) { return unit.name == name; });
  return row == angle_units.end() ? std::nullopt : std::optional(*row);
}

double in_degrees(double angle, double degrees_in_unit) {
  return degrees_in_unit == 1 ? angle : std::round(angle * degrees_in_unit * 1e6) / 1e6;
}

std::string doubt_of_degrees(std::span<const double> theta_i, std::span<const double> theta_s,
                             std::span<const double> phi, double largest_theta_s) {
  const double highest_i = largest(theta_i), highest_s = largest(theta_s), highest_phi = largest(phi);
  if (highest_phi > turn * rounding) return {};
  if (highest_i <= 0.5 * std::numbers::pi * rounding && highest_s <= largest_theta_s * rounding) {
    // A fine scan about one direction has one incidence, and angles that are round in degrees.
    const auto [low, high] = std::minmax_element(theta_i.begin(), theta_i.end());
    if (low == high || (*low == *high && are_round(theta_i) && are_round(theta_s))) return {};
    return fmt::format(
        "no theta_i is above {:.4g}, no theta_s above {:.4g} degrees: these look like radians; `angles` "
        "radians takes them so",
        highest_i, highest_s);
  }
  if (highest_phi > 1.5 && !are_round(phi) && are_multiples(phi, degrees_per_radian, 1, 0.02))
    return fmt::format(
        "no phi is above {:.5g} degrees, and all are whole degrees if taken as radians; `angles` "
        "azimuth-radians takes them so",
        highest_phi);
  return {};
}

}  // namespace brdftab

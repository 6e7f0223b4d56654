// The unit of a measured file's angles.
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "host/base/angle.hpp"

namespace brdftab {

struct AngleUnit {
  std::string_view name;
  /// How many degrees one unit of theta and one of phi has.
  double theta, phi;
};

/// "azimuth-radians" stands for theta in degrees and phi in radians.
inline constexpr std::array<AngleUnit, 3> angle_units{{{"degrees", 1, 1},
                                                       {"radians", degrees_per_radian, degrees_per_radian},
                                                       {"azimuth-radians", 1, degrees_per_radian}}};

/// Finds a unit by its name; none where the table has no such name.
std::optional<AngleUnit> parse_angle_unit(std::string_view name);

/// Gives degrees, without the last digits that radians in text leave; exact where the unit is the degree.
double in_degrees(double angle, double degrees_in_unit);

/// Says what makes angles that are read as degrees look like radians, and the setting that takes them so;
/// empty where nothing does. `largest_theta_s` is the largest that the layout can have, in radians.
std::string doubt_of_degrees(std::span<const double> theta_i, std::span<const double> theta_s,
                             std::span<const double> phi, double largest_theta_s = std::numbers::pi / 2);

}  // namespace brdftab

// Angles are degrees at the edges of the program and radians inside: the factors between the two.
#pragma once

#include <numbers>

namespace brdftab {

inline constexpr double degrees_per_radian = 180 / std::numbers::pi;
inline constexpr double radians_per_degree = std::numbers::pi / 180;

constexpr double radians(double degrees) { return degrees * radians_per_degree; }
constexpr double degrees(double radians) { return radians * degrees_per_radian; }

}  // namespace brdftab

// A polar angle stretched toward grazing, where the lobes narrow: in t = artanh(sin theta), N is even and
// analytic.
#pragma once

#include <cmath>
#include <numbers>

namespace brdftab {

inline constexpr double radian_per_degree = std::numbers::pi / 180;

/// t of a polar angle from 0 to below 90 degrees.
inline double stretched(double theta) {
  return std::log((1 + std::sin(theta * radian_per_degree)) / std::sin((90 - theta) * radian_per_degree));
}

/// The polar angle of t, degrees.
inline double unstretched(double t) { return 90 - std::asin(1 / std::cosh(t)) / radian_per_degree; }

}  // namespace brdftab

// A polar angle stretched toward grazing, where the lobes narrow: in t = artanh(sin theta), N is even and
// analytic.
#pragma once

#include <cmath>

#include "host/base/angle.hpp"

namespace brdftab {

/// t of a polar angle from 0 to below 90 degrees.
inline double stretched(double theta) {
  return std::log((1 + std::sin(radians(theta))) / std::sin(radians(90 - theta)));
}

/// The polar angle of t, degrees.
inline double unstretched(double t) { return 90 - std::asin(1 / std::cosh(t)) / radians_per_degree; }

}  // namespace brdftab

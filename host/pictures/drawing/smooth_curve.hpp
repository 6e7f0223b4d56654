// Curves sampled so that straight lines between the samples look smooth.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "host/pictures/drawing/frame.hpp"

namespace brdftab {

/// A place on one of several curves.
struct CurvePlace {
  std::size_t curve;
  double x;
};

/// y at many places at once.
using CurveValues = std::function<std::vector<double>(std::span<const CurvePlace>)>;

/// Samples curves from `starts[curve]`, which increase and hold every x where a narrow peak may be. Intervals
/// are halved until the middle lies within 0.1 of a unit of the chord, on a page where the starts' whole
/// range of x is 600 units wide and that of y, logarithmic and of at most `most_decades` or linear, 400 high.
/// Samples are at multiples of 1e-7.
std::vector<std::vector<ChartPoint>> smooth_curves(const std::vector<std::vector<double>>& starts,
                                                   const CurveValues& values, bool logarithmic,
                                                   double most_decades = 7);

/// From first to last by step, with more places in between; sorted, each once.
std::vector<double> curve_starts(double first, double last, double step, std::span<const double> more);

}  // namespace brdftab

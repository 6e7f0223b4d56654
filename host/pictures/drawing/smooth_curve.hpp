// Curves are sampled so densely that straight lines between the samples look smooth.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "host/pictures/drawing/frame.hpp"

namespace brdftab::drawing {

/// A value of x on one of several curves.
struct CurvePlace {
  std::size_t curve;
  double x;
};

/// Returns y at many places at once.
using CurveValues = std::function<std::vector<double>(std::span<const CurvePlace>)>;

/// Samples curves, each first at the values of x in `starts[curve]`, which have to increase and to hold every
/// x where a narrow peak may be. The intervals between samples are halved until the middle lies within 0.1
/// units of the chord. These units are of a page where the range of x is 600 wide and that of y 400 high; y
/// is linear, or logarithmic over at most `most_decades`. Every x is a multiple of 1e-7.
std::vector<std::vector<ChartPoint>> smooth_curves(const std::vector<std::vector<double>>& starts,
                                                   const CurveValues& values, bool logarithmic,
                                                   double most_decades = 7);

/// Values of x to start from: `first`, `last`, the multiples of `step` between them, and those of `more` that
/// lie between them. They increase, and each comes once.
std::vector<double> curve_starts(double first, double last, double step, std::span<const double> more);

}  // namespace brdftab::drawing

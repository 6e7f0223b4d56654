// How dense an axis must be for linear interpolation along it: nodes per degree, found by moving nodes until
// every interval has the same error.
#pragma once

#include <random>
#include <vector>

#include "host/compute/sampled_model.hpp"

namespace brdftab {

/// Shares of errors' scale: |interpolated - f| / max(f, interpolation_floor x the slice's peak).
inline constexpr double interpolation_floor = 0.01;

/// Directions drawn where errors are: over the whole ranges, and near the forward and the retro-reflecting
/// direction.
class DirectionDraw {
 public:
  DirectionDraw(AngleRange theta_i, AngleRange theta_s, std::uint64_t seed);

  double theta_i();
  /// Near x, at x, at an end, or anywhere, in a range.
  double near(double x, AngleRange range);
  /// In [0, 180]: anywhere, near 0, near 180, or one of them.
  double azimuth();
  double uniform(double low, double high);
  AngleRange theta_i_range() const { return theta_i_; }
  AngleRange theta_s_range() const { return theta_s_; }

 private:
  AngleRange theta_i_, theta_s_;
  std::mt19937_64 random_;
};

/// |interpolated - f| relative to its scale, over all brdfs; `f` and `interpolated` are [brdf][direction].
std::vector<double> relative_errors(const SampledModel& model, const Directions& directions,
                                    const std::vector<std::vector<double>>& f,
                                    const std::vector<std::vector<double>>& interpolated);

/// The axes that are chosen; phi is folded into [0, 180].
enum class ChosenAxis { theta_i, theta_s, phi };

/// A number of intervals spread over a range as errors need it.
class AxisDensity {
 public:
  /// Of an axis whose own interpolation error may be about `error` in every interval.
  AxisDensity(const SampledModel& model, ChosenAxis axis, AngleRange range, double error,
              DirectionDraw& source);

  /// Nodes, both ends included: `factor` times as many intervals as the error asked for takes.
  std::vector<double> nodes(double factor) const;

 private:
  std::vector<double> angle_;
  std::vector<double> intervals_;  // up to each angle
};

}  // namespace brdftab

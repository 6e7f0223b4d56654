// The settings of theta_i in a measurement: angles read back from an encoder, or that differ by rounding, are one setting.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brdftab {

/// Groups of angles of incidence, each narrower than a width. Neighbours are joined, the closest first, as long as all of a
/// group stays within the width; so a scan in steps finer than the width becomes many groups, never one long chain. Only
/// what is counted, listed or drawn by incidence goes by groups: a model is evaluated at each sample's own theta_i.
class Incidences {
 public:
  /// Degrees: ten times what encoders leave, a quarter of the finest common step.
  static constexpr double usual_width = 0.25;

  /// In degrees, in any order, repeated or not. A width of 0 tells every two numbers apart; a step of the width itself
  /// tells two settings apart.
  Incidences(std::span<const double> theta_i, double width);

  std::size_t size() const { return angles_.size(); }
  /// The mean of each group's angles, in degrees, increasing; rounded to 0.01 or, where they differ less, more finely.
  const std::vector<double>& angles() const { return angles_; }
  /// The group of an angle that the constructor was given.
  std::size_t index(double theta_i) const;
  /// Lowest and highest angle of a group, degrees.
  double lowest(std::size_t group) const { return lowest_[group]; }
  double highest(std::size_t group) const { return highest_[group]; }

 private:
  std::vector<double> angles_, lowest_, highest_;
};

}  // namespace brdftab

// A measurement has settings of theta_i: angles that were read back from an encoder, or that differ by
// rounding, are one setting.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brdftab {

/// Groups of angles of incidence, each narrower than a width. Neighbours are joined, the closest first, as
/// long as all of a group stays within the width; so a scan in steps finer than the width becomes many
/// groups, never one long chain. Only what is counted, listed or drawn by incidence goes by groups: a model
/// is evaluated at each sample's own theta_i.
class Incidences {
 public:
  /// Degrees: several times what encoders leave, and less than the steps that goniometers are set to.
  static constexpr double usual_width = 0.25;

  /// In degrees, in any order, repeated or not. A width of 0 tells every two numbers apart; a step of the
  /// width itself tells two settings apart.
  Incidences(std::span<const double> theta_i, double width);

  /// The same with whole groups joined over ever larger widths, until at most `most` are left; `most` is
  /// above 0.
  Incidences joined(std::size_t most) const;

  std::size_t size() const { return groups_.size(); }
  /// Gives the mean of each group's angles in degrees, rounded to 0.01 or, where they differ less, more
  /// finely; the means increase.
  double angle(std::size_t group) const;
  std::vector<double> angles() const;
  /// Gives the lowest and the highest angle of a group, degrees.
  double lowest(std::size_t group) const { return groups_[group].lowest; }
  double highest(std::size_t group) const { return groups_[group].highest; }
  /// Gives the group of an angle that the constructor was given.
  std::size_t index(double theta_i) const;

 private:
  struct Group {
    double lowest, highest, sum, count;
  };
  static std::vector<Group> join(const std::vector<Group>& groups, double width);

  std::vector<Group> groups_;  // by increasing angle
  double width_;
};

}  // namespace brdftab

// Samples at the nodes of four axes, as several formats hold them, with linear interpolation along each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/model/axis.hpp"
#include "host/model/directions.hpp"

namespace brdftab {

/// Gives every node of a grid as a pair of directions, in the order [theta_i][phi_i][theta_s][phi_s].
Directions directions_of(const Grid& grid);

/// Gives phi_s - phi_i between vectors that point away from the surface, for a grid with one phi_i: from 0 to
/// 360 degrees, both included, where 180 is the specular direction. Throws BadInput where there are several
/// phi_i, since f depends on the difference only.
std::vector<double> azimuths_away_from_surface(const Grid& grid);

class GridSamples {
 public:
  using Axes = std::array<std::vector<double>, 4>;

  /// Axes are in degrees, with the model's azimuths, and `values` is
  /// [channel][theta_i][phi_i][theta_s][phi_s]. Throws BadInput with `source` where an axis does not increase
  /// or the sizes do not agree.
  GridSamples(Axes axes, std::vector<std::vector<double>> values, const std::string& source);

  /// Takes a list of samples in any order: each row of `columns` = [4 + channels][row] has theta_i, phi_i,
  /// theta_s, phi_s and the channels' values. Throws BadInput with `source` where the rows are not every node
  /// of a grid once.
  static GridSamples from_rows(const std::vector<std::vector<double>>& columns, const std::string& source);

  const std::vector<double>& axis(AxisKind kind) const { return axes_[static_cast<std::size_t>(kind)]; }
  const Axes& axes() const { return axes_; }
  const std::vector<std::vector<double>>& values() const { return values_; }

  /// Gives every node as a pair of directions, in the order of a channel's values.
  Directions directions() const;
  /// Gives the same nodes with as many other values.
  GridSamples with_values(std::vector<std::vector<double>> values) const;

  AngleRange range(AxisKind kind) const { return {axis(kind).front(), axis(kind).back()}; }
  /// Gives the range of phi_s - phi_i between the first node and the last, at the first phi_i. It is -180 to
  /// 180 where the nodes go round, with no gap wider than twice the widest step, and where they are a half
  /// turn from 0 or 180 degrees on, which is mirrored.
  AngleRange phi_range() const;

  /// Gives [channel][direction] at the first phi_i. Polar angles beyond the nodes take the last node;
  /// azimuths wrap round, and are mirrored where phi_s - phi_i covers half a turn only.
  std::vector<std::vector<double>> evaluate(const Directions& directions) const;

 private:
  Axes axes_;
  std::vector<std::vector<double>> values_;
};

}  // namespace brdftab

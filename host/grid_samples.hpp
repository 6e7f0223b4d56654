// Samples at the nodes of four axes, as several formats hold them, with linear interpolation along each.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "host/axis.hpp"
#include "host/sampled_model.hpp"

namespace brdftab {

/// Every node of a grid as a pair of directions, [theta_i][phi_i][theta_s][phi_s].
Directions directions_of(const Grid& grid);

/// phi_s - phi_i between vectors that point away from the surface, of a grid with one phi_i: from 0 to 360 degrees, both
/// included, with 180 the specular direction. Throws BadInput where there are several phi_i: f depends on the difference only.
std::vector<double> azimuths_away_from_surface(const Grid& grid);

class GridSamples {
 public:
  /// Axes in degrees, with the model's azimuths; `values` [channel][theta_i][phi_i][theta_s][phi_s]. Throws BadInput where an
  /// axis does not increase or the sizes do not agree.
  GridSamples(std::array<std::vector<double>, 4> axes, std::vector<std::vector<double>> values);

  /// From a list of samples in any order: theta_i, phi_i, theta_s, phi_s and the channels' values in each row of
  /// `columns` = [4 + channels][row]. Throws BadInput with `source` where they are not every node of a grid once.
  static GridSamples from_rows(const std::vector<std::vector<double>>& columns, const std::string& source);

  const std::vector<double>& axis(AxisKind kind) const { return axes_[static_cast<std::size_t>(kind)]; }
  const std::vector<std::vector<double>>& values() const { return values_; }

  /// [channel][direction], at the first phi_i. Polar angles beyond the nodes take the last; azimuths wrap round, and where
  /// phi_s - phi_i covers half a turn only, are mirrored.
  std::vector<std::vector<double>> evaluate(const Directions& directions) const;

 private:
  std::array<std::vector<double>, 4> axes_;
  std::vector<std::vector<double>> values_;
};

}  // namespace brdftab

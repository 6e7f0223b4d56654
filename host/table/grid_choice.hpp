// Axes chosen by the program, so that linear interpolation of the table stays within an error.
#pragma once

#include <optional>
#include <vector>

#include "host/table/attribute.hpp"
#include "host/table/axis_density.hpp"

namespace brdftab {

/// Of linear interpolation: |interpolated - f| / max(f, interpolation_floor x the slice's peak).
struct GridError {
  std::size_t points = 0;
  double maximum = 0;
  double percentile_95 = 0;
  double uniform_maximum = 0;  // over the half of the points that is uniform in the angles
};

struct GridAtError {
  Grid grid;
  GridError error;
};

/// Nodes of uniform axes: theta_i, theta_s, phi_s.
struct UniformAxes {
  std::array<std::size_t, 3> nodes;
  double product() const {
    return static_cast<double>(nodes[0]) * static_cast<double>(nodes[1]) * static_cast<double>(nodes[2]);
  }
};

struct UniformNeed {
  /// The fewest nodes with which each axis alone, the others exact, is within the error: no uniform grid has
  /// fewer.
  UniformAxes alone;
  /// These, scaled until they are together.
  UniformAxes together;
};

class GridChooser {
 public:
  /// `ranges` gives each axis' first and last node; an axis of one node stays. f depends on phi_s - phi_i
  /// only: phi_i must have one node, or BadInput. `error` is relative, between 1e-4 and 1.
  GridChooser(const Engine& engine, const Material& material, const std::vector<Polarization>& polarizations,
              const Grid& ranges, double error);

  /// The smallest grid found that keeps within the error, as measured on points that its choice did not use.
  /// Throws BadInput where it takes more than `most_nodes` nodes, and tells what those reach.
  GridAtError choose(double most_nodes);

  /// Grids of other sizes round the chosen one, measured in the same way.
  std::vector<GridAtError> other_sizes();

  /// At all points, or at those that are uniform in the angles only.
  UniformNeed uniform_need(bool uniform_directions);

  /// For the table's attributes: what was asked, what was reached, and how it was measured.
  std::vector<AttributeInfo> attributes(const GridError& reached) const;

 private:
  struct Points;
  using Axes = std::array<std::vector<double>, 3>;  // theta_i, theta_s, phi_s

  Points draw(std::uint64_t seed) const;
  /// Interpolates along the axes that have nodes; the others are exact.
  GridError measure(const Axes& axes, const Points& points) const;
  Axes axes(double factor) const;
  Grid grid(const Axes& axes) const;
  std::vector<double> unfolded(const std::vector<double>& phi) const;
  double factor_for(double error) const;

  const Watch& watch_;
  Grid ranges_;
  double error_;
  double phi_i_;
  SampledModel model_;
  std::vector<AxisDensity> densities_;  // of the axes that have a range
  std::array<std::optional<std::size_t>, 3> density_of_;
  double factor_ = 1;
  std::uint64_t next_seed_;
};

}  // namespace brdftab

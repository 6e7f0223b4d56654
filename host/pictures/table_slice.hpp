// The samples of a table over the hemisphere of scatter directions at one angle of incidence.
#pragma once

#include <vector>

#include "host/pictures/drawing/chart.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

/// The azimuth in [0, 360) degrees that is the same direction.
double in_circle(double phi);

/// Whether TableSlice::is_round holds for the azimuths of a table at its first phi_i.
bool has_hemispheres(const Grid& grid);

class TableSlice {
 public:
  /// Reads the hemisphere at the first phi_i; `theta_i` is a node's index. Throws BadInput where it has more
  /// nodes than can be drawn.
  static TableSlice read(const Subject& subject, std::size_t theta_i, std::size_t band,
                         Polarization polarization);

  /// The values lie as [theta_s][phi]. The nodes are in degrees: theta_s increases, and phi = phi_s - phi_i
  /// is in any order.
  TableSlice(std::vector<double> theta_s, std::vector<double> phi, std::vector<double> values);

  const std::vector<double>& theta_s() const { return theta_s_; }
  const std::vector<double>& phi() const { return phi_; }
  double value(std::size_t theta_s, std::size_t phi) const { return values_[theta_s * phi_.size() + phi]; }

  /// Whether the azimuths, together with their mirror images in the plane of incidence, leave no gap above 90
  /// degrees.
  bool is_round() const;

  /// The value at a direction in degrees: linear in ln f between the nodes, nan beyond them. Where an azimuth
  /// has no node, its mirror image serves, because f is even in phi.
  double at(double theta_s, double phi) const;

  /// The values at the pixels of a HemisphereFigure. The last node of theta_s serves one pixel beyond itself,
  /// so that a table which ends near 90 degrees fills the disc.
  std::vector<double> at_pixels() const;

  /// The nodes in the plane of incidence over theta_s in degrees, which is negative on the backward side.
  std::vector<drawing::ChartPoint> in_plane() const;

 private:
  // An azimuth in [0, 360] degrees and the column of the node that has its value.
  struct Azimuth {
    double phi;
    std::size_t column;
  };

  std::vector<double> theta_s_, phi_, values_;
  std::vector<Azimuth> circle_;  // ends with the first azimuth again, 360 degrees further
};

}  // namespace brdftab

// One hemisphere of scatter directions of a table: its own nodes at one angle of incidence.
#pragma once

#include <vector>

#include "host/pictures/drawing/chart.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

/// An azimuth in degrees, in [0, 360).
double in_circle(double phi);

/// Whether a table's azimuths, at its first phi_i, go round as TableSlice::is_round says.
bool has_hemispheres(const Grid& grid);

class TableSlice {
 public:
  /// At the first phi_i. Throws BadInput where a hemisphere has more nodes than can be drawn.
  static TableSlice read(const Subject& subject, std::size_t theta_i, std::size_t band,
                         Polarization polarization);

  /// Values [theta_s][phi] over nodes in degrees: theta_s increases, phi = phi_s - phi_i in any order.
  TableSlice(std::vector<double> theta_s, std::vector<double> phi, std::vector<double> values);

  const std::vector<double>& theta_s() const { return theta_s_; }
  const std::vector<double>& phi() const { return phi_; }
  double value(std::size_t theta_s, std::size_t phi) const { return values_[theta_s * phi_.size() + phi]; }

  /// Whether its azimuths, with their mirror images in the plane of incidence, leave no gap above 90 degrees.
  bool is_round() const;

  /// Between nodes, linear in ln f; across the plane of incidence where nodes are missing, f being even in
  /// phi. nan beyond the nodes.
  double at(double theta_s, double phi) const;

  /// The same at the pixels of a HemisphereFigure; the last theta_s reaches to the rim if it is within a
  /// pixel of it.
  std::vector<double> at_pixels() const;

  /// The nodes in the plane of incidence, theta_s negative on the backward side.
  std::vector<ChartPoint> in_plane() const;

 private:
  // An azimuth in [0, 360] and the node that has its value.
  struct Azimuth {
    double phi;
    std::size_t column;
  };

  std::vector<double> theta_s_, phi_, values_;
  std::vector<Azimuth> circle_;  // the first again at its end, 360 degrees on
};

}  // namespace brdftab

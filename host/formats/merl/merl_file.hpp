// MERL's binary files hold f over the half-way and difference angles of Rusinkiewicz, in 90 x 90 x 180 cells
// of three channels.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "host/model/surface_vector.hpp"

namespace brdftab {

struct HalfDifference {
  double theta_h, theta_d, phi_d;  // degrees, phi_d in (-180, 180]
};

/// Gives the angles of a pair of vectors that point away from the surface.
HalfDifference half_difference(const SurfaceVector& to_light, const SurfaceVector& to_viewer);

/// Cell i of theta_h reaches from i^2/90 to (i + 1)^2/90 degrees, cells of theta_d and phi_d are a degree
/// wide.
struct MerlFile {
  static constexpr int cells_h = 90;
  static constexpr int cells_d = 90;
  static constexpr int cells_phi = 180;
  static constexpr std::size_t plane = std::size_t{cells_h} * cells_d * cells_phi;

  /// The values as stored, R, then G, then B; below 0 where a direction is below the horizon.
  std::vector<double> values = std::vector<double>(3 * plane);

  static std::size_t index(int channel, int h, int d, int phi) {
    return static_cast<std::size_t>(phi + cells_phi * (d + cells_d * (h + cells_h * channel)));
  }
  /// A stored value times this factor is f in 1/sr.
  static double scale(int channel);

  /// Gives f in 1/sr at angles in degrees, between the centres of cells. Cubic polynomials of ln f go through
  /// the four nearest centres along each axis, where theta_h counts by its cells' numbers. f is even in
  /// theta_h and theta_d, with period 180 degrees in phi_d. It is nan where one of those cells holds no
  /// light.
  double between_centers(int channel, const HalfDifference& at) const;

  /// Throws BadInput where it is no such file.
  static MerlFile read(std::istream& in, const std::string& source);
  /// Gives the file's bytes.
  std::string bytes() const;
};

}  // namespace brdftab

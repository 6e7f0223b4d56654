// MERL's binary files: f over the half-way and difference angles of Rusinkiewicz, 90 x 90 x 180 cells in
// three channels.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "host/model/surface_vector.hpp"

namespace brdftab {

struct HalfDifference {
  double theta_h, theta_d, phi_d;  // degrees, phi_d in (-180, 180]
};

/// Of a pair of vectors away from the surface.
HalfDifference half_difference(const SurfaceVector& to_light, const SurfaceVector& to_viewer);

/// Cell i of theta_h reaches from i^2/90 to (i + 1)^2/90 degrees, cells of theta_d and phi_d are a degree
/// wide.
struct MerlFile {
  static constexpr int cells_h = 90;
  static constexpr int cells_d = 90;
  static constexpr int cells_phi = 180;
  static constexpr std::size_t plane = std::size_t{cells_h} * cells_d * cells_phi;

  /// As stored, R, G, B; below 0 where a direction is below the horizon.
  std::vector<double> values = std::vector<double>(3 * plane);

  static std::size_t index(int channel, int h, int d, int phi) {
    return static_cast<std::size_t>(phi + cells_phi * (d + cells_d * (h + cells_h * channel)));
  }
  /// f in 1/sr of one that is stored.
  static double scale(int channel);

  /// f in 1/sr at angles in degrees, between the centres of cells: ln f by cubic polynomials through the four
  /// nearest centres along each axis, theta_h by its cells' numbers. f is even in theta_h and theta_d, with
  /// period 180 degrees in phi_d. nan where one of those cells holds no light.
  double between_centers(int channel, const HalfDifference& at) const;

  /// Throws BadInput where it is no such file.
  static MerlFile read(std::istream& in, const std::string& source);
  /// The file's bytes.
  std::string bytes() const;
};

}  // namespace brdftab

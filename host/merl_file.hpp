// MERL's binary files: f over the half-way and difference angles of Rusinkiewicz, 90 x 90 x 180 cells in three channels.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace brdftab {

/// Cell i of theta_h reaches from i^2/90 to (i + 1)^2/90 degrees, cells of theta_d and phi_d are a degree wide.
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

  /// Throws BadInput where it is no such file.
  static MerlFile read(std::istream& in, const std::string& source);
  /// The file's bytes.
  std::string bytes() const;
};

}  // namespace brdftab

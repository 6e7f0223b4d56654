// Pairs of directions in lists, and ranges of their angles.
#pragma once

#include <cstddef>
#include <vector>

namespace brdftab {

/// Polar angles and phi = phi_s - phi_i, in degrees, as the model takes them.
struct Directions {
  std::vector<double> theta_i, theta_s, phi;

  std::size_t size() const { return phi.size(); }
  void add(double i, double s, double azimuth) {
    theta_i.push_back(i);
    theta_s.push_back(s);
    phi.push_back(azimuth);
  }
};

/// A closed range of angles, degrees.
struct AngleRange {
  double first, last;
};

}  // namespace brdftab

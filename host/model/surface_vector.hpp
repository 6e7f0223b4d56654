// Unit vectors that point away from the surface, as the simulators' formats have them, from and to the
// model's angles: the one place where the two conventions meet.
#pragma once

#include <utility>

#include "host/model/directions.hpp"

namespace brdftab {

/// z along the normal, x at azimuth 0, azimuth counter-clockwise seen from the normal. Both vectors of a pair
/// point away from the surface, so that the mirror direction of (theta, phi) is (theta, phi + 180 degrees).
struct SurfaceVector {
  double x, y, z;

  /// Degrees.
  static SurfaceVector from_degrees(double theta, double phi);
  /// Polar angle, degrees; keeps its digits near 0 and 90.
  double theta() const;
  /// Azimuth in (-180, 180], degrees; 0 along the normal.
  double phi() const;

  SurfaceVector operator+(const SurfaceVector& other) const {
    return {x + other.x, y + other.y, z + other.z};
  }
  SurfaceVector operator*(double factor) const { return {x * factor, y * factor, z * factor}; }
  double dot(const SurfaceVector& other) const { return x * other.x + y * other.y + z * other.z; }
  SurfaceVector normalized() const;
};

/// An azimuth about the normal, degrees, from one convention to the other: phi_i of the model is that of the
/// light's travel, which is half a turn from the vector to the light. Its own inverse; the azimuth of scatter
/// is the same in both.
inline double incident_azimuth(double phi_i) { return phi_i + 180; }

/// phi = phi_s - phi_i of the model, degrees, from the azimuths of vectors away from the surface.
inline double model_phi(double phi_to_light, double phi_to_viewer) {
  return phi_to_viewer - incident_azimuth(phi_to_light);
}

/// Adds a pair given by vectors away from the surface.
void add(Directions& directions, const SurfaceVector& to_light, const SurfaceVector& to_viewer);

/// The vectors of a pair; the light travels towards azimuth 0, so its vector lies at azimuth 180 degrees.
SurfaceVector to_light(const Directions& directions, std::size_t k);
SurfaceVector to_viewer(const Directions& directions, std::size_t k);

/// To the viewer at `radial` degrees from the specular direction of light that travels towards azimuth 0;
/// azimuth 0 about the specular direction points to the normal.
SurfaceVector about_specular(double theta_i, double radial, double azimuth);
/// The radial angle and the azimuth in [0, 360) of such a vector, degrees.
std::pair<double, double> specular_angles(double theta_i, const SurfaceVector& to_viewer);

/// Every pair with light and viewer exchanged. f of a reciprocal surface is the same.
Directions exchanged(const Directions& directions);

}  // namespace brdftab

// A direction as the paper sees it: polar angle and its exact sine and cosine.
// Degrees are reduced before they become radians, so cos(89.9°) is sin(0.1°).
#pragma once

namespace brdftab::reference {

/// x87 extended: 64 bits of significand and exponents to e^±11355, so that the
/// reference has three digits to spare and V may fall to e^-11000.
using Real = long double;

/// sin and cos of an angle in degrees; exact at every multiple of 30° that has
/// a rational value, so that a critical angle may be hit exactly.
Real sin_degrees(Real degrees);
Real cos_degrees(Real degrees);

/// A polar angle: sin θ (direction cosine in the surface plane) and μ = cos θ.
struct Direction {
  Real sin;
  Real cos;

  static Direction from_degrees(double theta);
};

/// [(α − α₀)² + β²], Eq. (12), for θ_i, θ_s and φ in degrees: the squared distance of the
/// tangential parts of scattered and mirrored direction, seen in the frame that
/// bisects φ, where neither component cancels.
Real squared_distance(double theta_i, double theta_s, double phi);
/// The same from −α₀: the squared distance to the retro-reflected direction.
Real squared_distance_retro(double theta_i, double theta_s, double phi);

}  // namespace brdftab::reference

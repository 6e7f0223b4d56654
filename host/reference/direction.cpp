// Directions from degrees and their distances in the surface plane.
#include "host/reference/direction.hpp"

#include <cmath>
#include <numbers>

namespace brdftab::reference {
namespace {

constexpr Real radians_per_degree = std::numbers::pi_v<Real> / 180;

// 0 ≤ x ≤ 90.
Real sin_first_quadrant(Real x) {
  if (x == 30) return 0.5L;
  if (x == 90) return 1;
  return x <= 45 ? std::sin(x * radians_per_degree) : std::cos((90 - x) * radians_per_degree);
}

Real cos_first_quadrant(Real x) {
  if (x == 60) return 0.5L;
  if (x == 90) return 0;
  return x <= 45 ? std::cos(x * radians_per_degree) : std::sin((90 - x) * radians_per_degree);
}

Real squared(Real x) { return x * x; }

struct BisectorFrame {
  Real difference;  // sin θ_s − sin θ_i
  Real sum;         // sin θ_s + sin θ_i
  Real cos_half_phi;
  Real sin_half_phi;
};

BisectorFrame bisector_frame(double theta_i, double theta_s, double phi) {
  const Real i = theta_i, s = theta_s, half_phi = Real(phi) / 2;
  return {2 * cos_degrees((s + i) / 2) * sin_degrees((s - i) / 2), sin_degrees(s) + sin_degrees(i),
          cos_degrees(half_phi), sin_degrees(half_phi)};
}

}  // namespace

Real sin_degrees(Real degrees) {
  Real x = std::fmod(std::fabs(degrees), 360.0L);
  Real sign = degrees < 0 ? -1 : 1;
  if (x >= 180) {
    x -= 180;
    sign = -sign;
  }
  return sign * sin_first_quadrant(x > 90 ? 180 - x : x);
}

Real cos_degrees(Real degrees) {
  Real x = std::fmod(std::fabs(degrees), 360.0L);
  if (x > 180) x = 360 - x;
  return x > 90 ? -cos_first_quadrant(180 - x) : cos_first_quadrant(x);
}

Direction Direction::from_degrees(double theta) { return {sin_degrees(theta), cos_degrees(theta)}; }

Real squared_distance(double theta_i, double theta_s, double phi) {
  const BisectorFrame frame = bisector_frame(theta_i, theta_s, phi);
  return squared(frame.difference * frame.cos_half_phi) + squared(frame.sum * frame.sin_half_phi);
}

Real squared_distance_retro(double theta_i, double theta_s, double phi) {
  const BisectorFrame frame = bisector_frame(theta_i, theta_s, phi);
  return squared(frame.difference * frame.sin_half_phi) + squared(frame.sum * frame.cos_half_phi);
}

}  // namespace brdftab::reference

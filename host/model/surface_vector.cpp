#include "host/model/surface_vector.hpp"

#include <cmath>
#include <numbers>

#include "host/base/angle.hpp"

namespace brdftab {
namespace {

struct SineCosine {
  long double sine;
  long double cosine;
};

// An angle is reduced to [0, 45] degrees before it becomes radians, which is exact, so that cos 90 is 0; the
// sine of 30 degrees is exact, too.
SineCosine first_quadrant(long double degrees) {
  const auto radians = [](long double angle) { return angle * (std::numbers::pi_v<long double> / 180); };
  const auto sine_below_45 = [&](long double angle) { return angle == 30 ? 0.5L : std::sin(radians(angle)); };
  const long double rest = 90 - degrees;
  if (degrees <= 45) return {sine_below_45(degrees), std::cos(radians(degrees))};
  return {std::cos(radians(rest)), sine_below_45(rest)};
}

SineCosine sine_and_cosine(double degrees) {
  const long double turn = std::fmod(std::fabs(static_cast<long double>(degrees)), 360.0L);
  const long double half_turn = turn > 180 ? 360 - turn : turn;
  auto [sine, cosine] = first_quadrant(half_turn > 90 ? 180 - half_turn : half_turn);
  return {(degrees < 0) == (turn >= 180) ? sine : -sine, half_turn > 90 ? -cosine : cosine};
}

}  // namespace

SurfaceVector SurfaceVector::from_degrees(double theta, double phi) {
  const SineCosine polar = sine_and_cosine(theta);
  const SineCosine azimuth = sine_and_cosine(phi);
  return {static_cast<double>(polar.sine * azimuth.cosine), static_cast<double>(polar.sine * azimuth.sine),
          static_cast<double>(polar.cosine)};
}

double SurfaceVector::theta() const { return std::atan2(std::hypot(x, y), z) * degrees_per_radian; }

double SurfaceVector::phi() const { return x == 0 && y == 0 ? 0 : std::atan2(y, x) * degrees_per_radian; }

SurfaceVector SurfaceVector::normalized() const { return *this * (1 / std::sqrt(dot(*this))); }

void add(Directions& directions, const SurfaceVector& to_light, const SurfaceVector& to_viewer) {
  directions.add(to_light.theta(), to_viewer.theta(), model_phi(to_light.phi(), to_viewer.phi()));
}

SurfaceVector to_light(const Directions& directions, std::size_t k) {
  return SurfaceVector::from_degrees(directions.theta_i[k], incident_azimuth(0));
}

SurfaceVector to_viewer(const Directions& directions, std::size_t k) {
  return SurfaceVector::from_degrees(directions.theta_s[k], directions.phi[k]);
}

SurfaceVector about_specular(double theta_i, double radial, double azimuth) {
  const SurfaceVector i = SurfaceVector::from_degrees(theta_i, 0);  // sine and cosine of theta_i
  const SurfaceVector local = SurfaceVector::from_degrees(radial, azimuth);
  return {local.z * i.x - local.x * i.z, local.y, local.z * i.z + local.x * i.x};
}

std::pair<double, double> specular_angles(double theta_i, const SurfaceVector& to_viewer) {
  const SurfaceVector i = SurfaceVector::from_degrees(theta_i, 0);
  const SurfaceVector local{to_viewer.z * i.x - to_viewer.x * i.z, to_viewer.y,
                            to_viewer.z * i.z + to_viewer.x * i.x};
  const double azimuth = local.phi();
  return {local.theta(), azimuth < 0 ? azimuth + 360 : azimuth};
}

Directions exchanged(const Directions& directions) {
  Directions result = directions;
  std::swap(result.theta_i, result.theta_s);
  return result;
}

}  // namespace brdftab

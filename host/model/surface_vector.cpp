#include "host/model/surface_vector.hpp"

#include <cmath>
#include <numbers>

#include "host/reference/direction.hpp"

namespace brdftab {

constexpr double degrees_per_radian = 180 / std::numbers::pi;

SurfaceVector SurfaceVector::from_degrees(double theta, double phi) {
  using reference::cos_degrees, reference::sin_degrees;
  const auto sine = sin_degrees(theta);
  return {static_cast<double>(sine * cos_degrees(phi)), static_cast<double>(sine * sin_degrees(phi)),
          static_cast<double>(cos_degrees(theta))};
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

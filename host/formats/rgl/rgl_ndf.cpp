#include "host/formats/rgl/rgl_ndf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/formats/rgl/rgl_content.hpp"

namespace brdftab {
namespace {

constexpr double pi = std::numbers::pi;

// Half vectors towards the horizon are taken no further from the normal than this, degrees: there f may
// vanish.
constexpr double furthest = 50;
// No density is taken below this share of the largest one.
constexpr double smallest_density = 1e-6;

/// Integrates a function of the polar angle, radians, times the density over half vectors.
template <class Function>
double integral(const std::vector<double>& density, const Function& function) {
  double sum = 0;
  const auto steps = static_cast<double>(density.size() - 1);
  for (std::size_t k = 0; k < density.size(); ++k) {
    const double x = static_cast<double>(k) / steps, end = k == 0 || k + 1 == density.size() ? 0.5 : 1;
    sum += end * density[k] * RglPlace::solid_angle(x) * function(radians(RglPlace::theta(x))) / steps;
  }
  return sum;
}

/// Gives the mean over the half vectors' azimuth of their cosine with a direction, which is 0 where negative.
double mean_cosine(double theta_i, double theta_m) {
  const double level = std::cos(theta_i) * std::cos(theta_m), swing = std::sin(theta_i) * std::sin(theta_m);
  if (level >= swing) return level;
  const double edge = std::acos(-level / swing);
  return (level * edge + swing * std::sin(edge)) / pi;
}

}  // namespace

std::vector<double> mean_of_bands(const std::vector<std::vector<double>>& by_band) {
  std::vector<double> mean(by_band.front().size());
  for (const auto& band : by_band)
    for (std::size_t k = 0; k < band.size(); ++k) mean[k] += band[k] / static_cast<double>(by_band.size());
  return mean;
}

std::vector<double> half_vector_density(const ExportModel& source, std::size_t nodes) {
  Directions directions;
  const double along = std::sqrt(0.5);
  for (std::size_t k = 0; k < nodes; ++k) {
    const double x = static_cast<double>(k) / static_cast<double>(nodes - 1);
    const double theta = furthest * std::tanh(RglPlace::theta(x) / furthest);
    const SurfaceVector half = SurfaceVector::from_degrees(theta, 0) * along, side{0, along, 0};
    add(directions, half + side, half + side * -1);
  }
  auto density = mean_of_bands(source.evaluate(directions));
  const double largest = *std::max_element(density.begin(), density.end());
  if (!(largest > 0))
    throw BadInput("{}: f is 0 about the mirror direction, and an RGL file needs a lobe there",
                   source.material().name());
  for (double& value : density) value = std::max(value, smallest_density * largest);
  const double area = integral(density, [](double theta) { return std::cos(theta); });
  for (double& value : density) value /= area;
  return density;
}

std::vector<double> projected_area(const std::vector<double>& density, std::size_t nodes) {
  std::vector<double> area;
  for (std::size_t k = 0; k < nodes; ++k) {
    const double theta_i = radians(RglPlace::theta(static_cast<double>(k) / static_cast<double>(nodes - 1)));
    area.push_back(integral(density, [&](double theta_m) { return mean_cosine(theta_i, theta_m); }));
  }
  return area;
}

}  // namespace brdftab

#include "host/formats/merl/merl_measurement.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/formats/merl/merl_file.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

// MERL's own measurements are unreliable beyond this angle, degrees.
constexpr int largest_theta = 80;
constexpr int step_i = 10;
constexpr int step_s_in_plane = 2;
// Samples over the hemisphere have few polar angles, since a fit integrates N at each, in either role.
constexpr int step_s = 5;
// These shares of the samples lie near the peaks; the others are uniform in solid angle.
constexpr double near_mirror = 0.2, near_retro = 0.1;
// Samples near a peak have azimuths from its centre within these bounds, degrees, as many in each factor of
// two.
constexpr double nearest = 0.5, farthest = 32;

struct Direction {
  double theta_s, phi;  // degrees; theta_s below 0 is the backward side in plane
};

std::vector<Direction> in_plane() {
  std::vector<Direction> directions;
  for (int theta_s = -largest_theta; theta_s <= largest_theta; theta_s += step_s_in_plane)
    directions.push_back({double(theta_s), 0});
  return directions;
}

// Draws numbers in [0, 1) that are the same with every standard library.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  double operator()() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }

 private:
  std::mt19937_64 engine_;
};

std::vector<Direction> over_hemisphere(double theta_i, std::size_t count, Random& random) {
  std::vector<double> below{0};  // the solid angle of rings below each theta_s
  for (int theta_s = step_s; theta_s <= largest_theta; theta_s += step_s)
    below.push_back(below.back() + std::sin(radians(theta_s)));
  const auto about_mirror = static_cast<std::size_t>(near_mirror * static_cast<double>(count));
  const auto about_retro = static_cast<std::size_t>(near_retro * static_cast<double>(count));
  std::vector<Direction> directions;
  for (std::size_t k = 0; k < about_mirror + about_retro; ++k) {
    const double offset = nearest * std::pow(farthest / nearest, random());
    directions.push_back({theta_i, k < about_mirror ? offset : 180 - offset});
  }
  const std::size_t uniform = count - directions.size();
  for (std::size_t k = 0; k < uniform; ++k) {
    // The draw is stratified: each ring has its part of the samples, to within one.
    const double place = (static_cast<double>(k) + random()) / static_cast<double>(uniform) * below.back();
    const auto ring = std::upper_bound(below.begin(), below.end(), place) - below.begin() - 1;
    directions.push_back({static_cast<double>((ring + 1) * step_s), 360 * random() - 180});
  }
  return directions;
}

}  // namespace

Measurement read_merl_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options) {
  if (options.angles)
    throw BadInput("{}: `angles` {}: a MERL file holds no angles", source, options.angles->name);
  const MerlFile file = MerlFile::read(in, source);
  Measurement measurement{.source = source,
                          .channels = {"R", "G", "B"},
                          .samples = {},
                          .warnings = {},
                          .mean_of_exchanges = true};
  Random random(options.merl_seed);
  const bool is_in_plane = options.merl_samples == 0;
  // Over the hemisphere the normal is left out: the azimuth of incidence, which V_m takes, is that of no cell
  // there.
  const int first = is_in_plane ? 0 : step_i;
  constexpr std::size_t incidences = largest_theta / step_i;
  std::size_t invalid = 0, taken = 0, remainder = options.merl_samples % incidences;
  for (int theta_i = first; theta_i <= largest_theta; theta_i += step_i) {
    const std::size_t count = options.merl_samples / incidences + (remainder > 0 ? 1 : 0);
    remainder -= remainder > 0 ? 1 : 0;
    for (const auto& [theta_s, phi] : is_in_plane ? in_plane() : over_hemisphere(theta_i, count, random)) {
      const HalfDifference at = half_difference(SurfaceVector::from_degrees(theta_i, incident_azimuth(0)),
                                                SurfaceVector::from_degrees(theta_s, phi));
      ++taken;
      for (int c = 0; c < 3; ++c) {
        const double brdf = file.between_centers(c, at);
        if (std::isnan(brdf))
          ++invalid;
        else
          measurement.samples.push_back({.pair = {double(theta_i), theta_s, phi, 0},
                                         .brdf = brdf,
                                         .channel = static_cast<std::size_t>(c)});
      }
    }
  }
  measurement.notes.push_back(fmt::format(
      "{} directions{}, in {} cells: theta_i {} to {} by {}; ln f is interpolated between the centres of "
      "cells, each the mean over about a degree; f is the mean of both orders of light and view, and so is a "
      "model's beside it: f of one order is not in the file, and differs from it the less with `model` "
      "normalization=reciprocal",
      taken,
      is_in_plane
          ? " in plane"
          : fmt::format(" over the hemisphere (`merl_samples`), drawn with seed {} (`merl_seed`), {:.0f} % "
                        "of them uniform in solid angle, the others near the mirror and retro directions",
                        options.merl_seed, 100 * (1 - near_mirror - near_retro)),
      MerlFile::plane, first, largest_theta, step_i));
  if (invalid > 0)
    measurement.warnings.push_back(
        fmt::format("{} of {} values lie beside cells that are invalid or 0: set aside", invalid, 3 * taken));
  return measurement;
}

}  // namespace brdftab

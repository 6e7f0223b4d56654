// Values may look like another quantity than f in 1/sr.
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"
#include "host/model/measurement/doubts.hpp"

namespace brdftab {
namespace {

// A diffuse reflectance is suspicious if it is above 1 by more than a measurement's error; a reflectance
// factor reads at most pi times too high.
constexpr double suspicious_reflectance = 1.1;
// Grazing samples may be large, whatever the unit.
constexpr double largest_theta = 60;
// Most lobes end within this distance, in direction cosines, from the mirror and the retro-reflected
// direction.
constexpr double beyond_lobes = 0.3;
constexpr std::size_t fewest_of_incidence = 5, fewest = 3;

// A tenth of the values lie below this one: the diffuse level, whatever peaks there are.
double low_level(std::vector<double> values) { return percentile(values, 10); }

// Distances are taken in the plane of direction cosines, where lobes are about circles.
double distance_from_peaks(const DirectionPair& pair) {
  const double alpha_0 = std::sin(radians(pair.theta_i)), sine = std::sin(radians(pair.model_theta_s()));
  const double alpha = sine * std::cos(radians(pair.model_phi())),
               beta = sine * std::sin(radians(pair.model_phi()));
  return std::min(std::hypot(alpha - alpha_0, beta), std::hypot(alpha + alpha_0, beta));
}

// Gives the lowest diffuse level over the incidences or, where those have few samples, that of all samples;
// infinite where none can tell.
double diffuse_level(const Measurement& measurement) {
  const Incidences incidences = measurement.incidences();
  std::map<std::pair<std::size_t, std::size_t>, std::vector<double>> by_incidence;
  std::map<std::size_t, std::vector<double>> by_channel;
  for (const auto& [pair, brdf, sigma, channel, share_s] : measurement.samples) {
    if (!(brdf > 0) || std::max(pair.theta_i, pair.model_theta_s()) > largest_theta) continue;
    if (distance_from_peaks(pair) < beyond_lobes) continue;
    by_incidence[{channel, incidences.index(pair.theta_i)}].push_back(brdf);
    by_channel[channel].push_back(brdf);
  }
  double lowest = std::numeric_limits<double>::infinity();
  for (const auto& [incidence, values] : by_incidence)
    if (values.size() >= fewest_of_incidence) lowest = std::min(lowest, low_level(values));
  if (std::isfinite(lowest)) return lowest;
  for (const auto& [channel, values] : by_channel)
    if (values.size() >= fewest) lowest = std::min(lowest, low_level(values));
  return lowest;
}

// Gives the values of one channel, in the order of the file.
std::map<std::size_t, std::vector<double>> values_by_channel(const Measurement& measurement) {
  std::map<std::size_t, std::vector<double>> result;
  for (const auto& sample : measurement.samples)
    if (!std::isnan(sample.brdf)) result[sample.channel].push_back(sample.brdf);
  return result;
}

constexpr double clearly_negative = -0.1;
// Counts the stretches of equal sign: a logarithm's peaks are above 0 in few of them, while noise about 0
// changes its sign at every other sample.
constexpr double most_changes_of_sign = 0.2;

// Takes the values in the order of the file.
bool look_like_logarithms(const std::vector<double>& values) {
  std::vector<double> sorted = values;
  if (lower_percentile(sorted, 50) < clearly_negative) return true;
  if (lower_percentile(sorted, 10) >= clearly_negative) return false;
  std::size_t changes = 0;
  for (std::size_t k = 1; k < values.size(); ++k) changes += (values[k] < 0) != (values[k - 1] < 0);
  return static_cast<double>(changes) < most_changes_of_sign * static_cast<double>(values.size());
}

}  // namespace

std::string doubt_of_level(const Measurement& measurement) {
  const double level = diffuse_level(measurement);
  if (!std::isfinite(level)) return {};
  const double reflectance = std::numbers::pi * level;
  if (reflectance <= suspicious_reflectance) return {};
  const std::string what = fmt::format(
      "f is at least {:.3g} 1/sr at nearly all directions away from its peaks, a reflectance of {:.3g}: this "
      "looks like ",
      level, reflectance);
  if (reflectance <= suspicious_reflectance * std::numbers::pi)
    return what +
           "pi f, which `values` pi-f (or `scale` 0.3183099) mends, or like percent of a dark surface, which "
           "`values` percent mends";
  return what +
         "percent: `values` percent mends 100 pi f (100 of a perfect diffuser), `scale` 0.01 mends 100 f";
}

std::string doubt_of_logarithms(const Measurement& measurement) {
  std::size_t negative = 0, count = 0;
  double median = 0;
  bool found = false;
  for (auto& [channel, values] : values_by_channel(measurement)) {
    count += values.size();
    negative +=
        static_cast<std::size_t>(std::count_if(values.begin(), values.end(), [](double v) { return v < 0; }));
    if (!look_like_logarithms(values)) continue;
    found = true;
    median = std::min(median, lower_percentile(values, 50));
  }
  if (!found) return {};
  // No surface is as dark as 1e-8 1/sr nearly everywhere.
  constexpr double darkest = -8;
  std::vector<std::string_view> likely;
  if (median > darkest) likely.push_back("log10");
  if (median > darkest * std::numbers::ln10) likely.push_back("ln");
  likely.push_back("db");
  return fmt::format(
      "{} of {} values are negative, in whole stretches: they look like logarithms of f; `values` {} takes "
      "them so (log10 f, ln f, 10 log10 f)",
      negative, count, fmt::join(likely, ", `values` "));
}

}  // namespace brdftab

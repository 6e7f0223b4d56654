#include "host/fit/uncertainty/fit_bias.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "host/base/angle.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr double tolerated_share = 0.05;

struct Sums {
  double fitted = 0, measured = 0;

  double excess() const { return measured > 0 ? fitted / measured : HUGE_VAL; }
};

}  // namespace

std::optional<LowReadingsLeftOut> low_readings_left_out(const Engine& engine, const FitProblem& problem,
                                                        const std::vector<Parameters>& bands) {
  const std::size_t all = problem.samples() + problem.below_floor();
  if (static_cast<double>(problem.below_floor()) <= tolerated_share * static_cast<double>(all))
    return std::nullopt;
  std::vector<double> angles;
  for (const FitBand& band : problem.bands())
    for (const auto* samples : {&band.samples, &band.below_floor})
      for (const auto& sample : *samples) angles.push_back(sample.pair.theta_i);
  const Incidences settings(angles, problem.incidence_width());
  std::map<std::pair<std::size_t, std::size_t>, Sums> sums;  // by band and setting
  for (std::size_t b = 0; b < bands.size(); ++b) {
    std::vector<MeasuredSample> samples = problem.bands()[b].samples;
    const auto& low = problem.bands()[b].below_floor;
    samples.insert(samples.end(), low.begin(), low.end());
    const LogBrdfValues values = problem.values_at(engine, samples, bands[b]);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const double theta_s = radians(samples[k].pair.model_theta_s());
      const double weight = std::cos(theta_s) * std::sin(theta_s);
      Sums& at = sums[{b, settings.index(samples[k].pair.theta_i)}];
      at.fitted += weight * std::exp(values.ln_f(0)[k]);
      at.measured += weight * samples[k].brdf;
    }
  }
  const auto worst = std::max_element(sums.begin(), sums.end(), [](const auto& a, const auto& b) {
    return a.second.excess() < b.second.excess();
  });
  return LowReadingsLeftOut{problem.below_floor(), all, settings.angle(worst->first.second),
                            worst->second.fitted, worst->second.measured};
}

std::string text_of(const LowReadingsLeftOut& low, const FitOptions& options) {
  std::string excess = "the fitted f does not exceed the mean of all readings at any theta_i";
  if (!(low.measured_sum > 0))
    excess = fmt::format(
        "at theta_i = {} degrees all readings, those left out included, sum to no more than 0, the fitted f "
        "does not",
        shortest(low.theta_i));
  else if (low.fitted_sum > low.measured_sum)
    excess = fmt::format(
        "at theta_i = {} degrees the fitted f is {:.2g} times all readings, those left out included (sums "
        "weighted by cos theta_s sin theta_s), and DHR too high by about as much",
        shortest(low.theta_i), low.fitted_sum / low.measured_sum);
  return fmt::format(
      "{} of {} samples ({:.0f} %) are left out as not above {} 1/sr: what is kept is too high on average, "
      "which biases f and DHR upward: {}; `weights` sigma (with a column sigma) and `noise` (without) take "
      "every reading",
      low.count, low.all, 100. * static_cast<double>(low.count) / static_cast<double>(low.all),
      shortest(options.floor), excess);
}

}  // namespace brdftab

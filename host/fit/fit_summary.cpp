#include "host/fit/fit_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/compute/integrals.hpp"
#include "host/fit/uncertainty/fit_profile.hpp"

namespace brdftab {
namespace {

constexpr std::size_t most_correlations = 6;
constexpr std::size_t most_incidences = 20;

std::string name_of(const FitProblem& problem, const FitVariable& variable) {
  if (variable.bands.size() == problem.bands().size()) return std::string(variable.row().name);
  return fmt::format("{}[{}]", variable.row().name, problem.bands()[variable.bands.front()].channel);
}

// Each entry costs an integral of the model over the hemisphere.
std::vector<IncidenceFit> by_incidence(const Engine& engine, const FitProblem& problem,
                                       const std::vector<double>& u) {
  const Incidences& settings = problem.incidences();
  const Incidences listed = settings.joined(most_incidences);
  const std::vector<double> angles = listed.angles();
  const double share_s = problem.share_s();
  const auto parameters = problem.parameters(u);
  const auto evaluated = problem.batch().evaluate(parameters);
  std::vector<IncidenceFit> result;
  for (std::size_t b = 0; b < problem.bands().size(); ++b) {
    const auto ratios = problem.misfits(evaluated[b], b);
    std::vector<std::pair<double, std::size_t>> sums(listed.size());
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      auto& [squares, count] = sums[listed.index(problem.bands()[b].samples[k].pair.theta_i)];
      squares += ratios[k] * ratios[k];
      ++count;
    }
    const Dhr dhr = integrals(engine, {problem.bands()[b].wavelength_nm, parameters[b]},
                              problem.options().variant, angles)
                        .dhr;
    for (std::size_t k = 0; k < listed.size(); ++k) {
      const auto& [squares, count] = sums[k];
      if (count == 0) continue;
      result.push_back(
          {problem.bands()[b].channel, angles[k], settings.angle(settings.index(listed.lowest(k))),
           settings.angle(settings.index(listed.highest(k))), count,
           std::sqrt(squares / static_cast<double>(count)),
           share_s * dhr.total(k, Polarization::s) + (1 - share_s) * dhr.total(k, Polarization::p)});
    }
  }
  return result;
}

std::vector<Correlation> strongest_correlations(const FitProblem& problem, const LinearUncertainty& linear) {
  std::vector<Correlation> result;
  for (Eigen::Index i = 0; i < linear.covariance.rows(); ++i)
    for (Eigen::Index j = 0; j < i; ++j) {
      const double value =
          linear.covariance(i, j) / std::sqrt(linear.covariance(i, i) * linear.covariance(j, j));
      const auto name = [&](Eigen::Index k) {
        return name_of(problem, problem.variables()[linear.active[static_cast<std::size_t>(k)]]);
      };
      result.push_back({name(j), name(i), value});
    }
  std::stable_sort(result.begin(), result.end(),
                   [](const auto& a, const auto& b) { return std::abs(a.value) > std::abs(b.value); });
  if (result.size() > most_correlations) result.resize(most_correlations);
  return result;
}

}  // namespace

FitSummary summarize(const Engine& engine, const FitProblem& problem, Fit fit, bool profile) {
  FitSummary summary{};
  std::vector<Interval95> intervals;
  if (profile) intervals = profile_intervals(problem, fit.best);
  summary.linear = linear_uncertainty(problem, fit.best);
  if (!profile) intervals = linear_intervals(problem, fit.best, summary.linear);
  summary.bands = problem.parameters(fit.best.u);
  std::vector<std::size_t> poorly_known;
  for (std::size_t v = 0; v < problem.variables().size(); ++v) {
    const FitVariable& variable = problem.variables()[v];
    const double value = variable.from_solver(fit.best.u[v]);
    const double error = summary.linear.standard_error(v) * variable.slope(fit.best.u[v]);
    summary.variables.push_back({name_of(problem, variable), value,
                                 std::isfinite(error) ? error : std::numeric_limits<double>::quiet_NaN(),
                                 intervals[v], variable.at_minimum(value) || variable.at_maximum(value),
                                 true});
    summary.variables.back().has_interval = profile || !summary.variables.back().at_bound;
    if (summary.variables.back().poorly_known() && std::isfinite(error)) poorly_known.push_back(v);
  }
  summary.correlations = strongest_correlations(problem, summary.linear);
  summary.incidences = by_incidence(engine, problem, fit.best.u);
  summary.sufficiency = sufficiency(engine, problem, fit.best, summary.linear, poorly_known);
  summary.log_rms = problem.log_rms(fit.best.u);
  summary.low_readings = low_readings_left_out(engine, problem, summary.bands);
  summary.profiled = profile;
  summary.fit = std::move(fit);
  return summary;
}

}  // namespace brdftab

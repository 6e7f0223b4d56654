#include "host/fit/fit.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "host/base/error.hpp"
#include "host/fit/fit_starts.hpp"
#include "host/fit/uncertainty/fit_uncertainty.hpp"

namespace brdftab {
namespace {

// Threads mostly wait for each other's evaluations; this many share one launch.
constexpr std::size_t starts_at_once = 32;
constexpr std::size_t most_polished = 6;
// A start whose rms is at most this many times the best has reached it.
constexpr double reached_rms = 1.01;

constexpr int cauchy_rounds = 5;
constexpr int most_noise_rounds = 40;
// Where every sigma changes by less than this part, no digit that is told moves.
constexpr double settled_noise = 1e-5;

constexpr Patience first_descent{.iterations = 80, .tolerance = 1e-5};
constexpr Patience polish{.iterations = 400, .tolerance = 1e-13};

std::vector<Minimum> descend(const FitProblem& problem, const std::vector<std::vector<double>>& starts,
                             const Patience& patience) {
  std::vector<Minimum> minima(starts.size());
  problem.batch().run(starts.size(), starts_at_once,
                      [&](std::size_t k) { minima[k] = minimize(problem, starts[k], patience); });
  return minima;
}

void sort_by_cost(std::vector<Minimum>& minima) {
  std::stable_sort(minima.begin(), minima.end(),
                   [](const auto& a, const auto& b) { return a.cost < b.cost; });
}

std::vector<std::vector<double>> best_points(const std::vector<Minimum>& sorted, std::size_t count) {
  std::vector<std::vector<double>> points;
  for (const Minimum& minimum : sorted)
    if (points.size() < count && std::isfinite(minimum.cost)) points.push_back(minimum.u);
  return points;
}

double update_noise(FitProblem& problem, const Minimum& best) {
  return problem.update_noise(best.u, freedom(linear_uncertainty(problem, best)));
}

// What the residuals are measured by, the noise and the scale of a robust loss, follows from the fit itself:
// it stays as it is while a descent goes on, and is renewed between descents until it settles.
void settle(FitProblem& problem, std::vector<Minimum>& polished) {
  const FitOptions& options = problem.options();
  const bool is_robust = options.loss == FitLoss::cauchy;
  const int rounds = options.noise ? most_noise_rounds : is_robust ? cauchy_rounds : 0;
  for (int round = 0; round < rounds && !polished.empty(); ++round) {
    const double change = options.noise ? update_noise(problem, polished.front()) : 1;
    if (change < settled_noise && round >= (is_robust ? cauchy_rounds : 0)) return;
    if (is_robust) problem.update_loss_scale(polished.front().u);
    polished = descend(problem, best_points(polished, most_polished), polish);
    sort_by_cost(polished);
  }
}

}  // namespace

Fit fit(FitProblem& problem) {
  const auto begin = std::chrono::steady_clock::now();
  const FitOptions& options = problem.options();
  std::vector<Minimum> minima =
      descend(problem, fit_starts(problem, options.starts, options.seed), first_descent);
  sort_by_cost(minima);
  std::vector<Minimum> polished = descend(problem, best_points(minima, most_polished), polish);
  sort_by_cost(polished);
  settle(problem, polished);
  Fit result{.best = {},
             .starts = options.starts,
             .converged = 0,
             .reached = 0,
             .seconds = 0,
             .kernel_seconds = 0,
             .evaluations = 0};
  for (const Minimum& minimum : minima) result.converged += minimum.converged && std::isfinite(minimum.cost);
  if (result.converged == 0 || polished.empty() || !std::isfinite(polished.front().cost))
    throw Error(Fault::check, "none of {} starts converged; `starts` and `seed` try others", options.starts);
  result.best = polished.front();
  for (const Minimum& minimum : minima)
    result.reached += std::sqrt(minimum.cost) <= reached_rms * std::sqrt(minima.front().cost);
  result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  result.kernel_seconds = problem.batch().seconds();
  result.evaluations = problem.batch().materials();
  return result;
}

}  // namespace brdftab

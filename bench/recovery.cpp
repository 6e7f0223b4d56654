// Fits to measurements that the reference made: are f and the parameters found again, and do the intervals
// cover them?
//
// usage: recovery [MATERIALS] [SEED]          noise-free data of random materials
//        recovery coverage [TRIALS] [SEED]    3 % noise, intervals by profile likelihood
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <map>

#include "bench/synthetic.hpp"
#include "host/fit/fit_summary.hpp"
#include "tests/random_materials.hpp"

namespace {

using namespace brdftab;

FitOptions options(std::size_t starts, std::uint64_t seed) {
  FitOptions result;
  result.starts = starts;
  result.seed = seed;
  result.floor = 0;
  return result;
}

int recover(const Engine& engine, int materials, unsigned seed) {
  RandomMaterials random(seed);
  std::mt19937_64 unused;
  int found = 0;
  for (int k = 0; k < materials; ++k) {
    const Parameters truth = random.plausible();
    FitProblem problem(engine, synthetic_measurement(truth, 10, 0.5, 0, unused), options(48, 1));
    const Fit result = fit(problem);
    const auto residuals = problem.residuals(result.best.u);
    double worst = 0;
    for (std::size_t r = 0; r < residuals.values.size(); ++r)
      worst = std::max(worst, std::abs(residuals.values[r]));
    const LinearUncertainty linear = linear_uncertainty(problem, result.best);
    // A parameter is identifiable if f to 1e-6 fixes it to 1e-3.
    std::string parameters;
    const Parameters fitted = problem.parameters(result.best.u)[0];
    int identifiable = 0;
    int recovered = 0;
    for (std::size_t v = 0; v < problem.variables().size(); ++v) {
      const double error = linear.standard_error(v) / std::sqrt(linear.variance) * 1e-6;
      if (!(error < 1e-3)) continue;
      ++identifiable;
      const auto& row = problem.variables()[v].row();
      const bool same = std::abs(fitted.*row.member - truth.*row.member) <= 1e-3 * (truth.*row.member) + 1e-6;
      recovered += same;
      if (!same)
        parameters += fmt::format(" {}: {:.6g} for {:.6g};", row.name, fitted.*row.member, truth.*row.member);
    }
    found += worst < 1e-6;
    fmt::print(
        "{:2}: largest error of f {:.1e}, {} of {} identifiable parameters within 1e-3, {:.1f} s, reached by "
        "{} of {}{}\n",
        k + 1, worst, recovered, identifiable, result.seconds, result.reached, result.starts, parameters);
    if (worst >= 1e-6) fmt::print("    {}\n", text_of(truth));
    std::fflush(stdout);
  }
  fmt::print("f recovered to 1e-6 everywhere: {} of {}\n", found, materials);
  return found == materials ? 0 : 1;
}

// All terms of these materials matter and no parameter is at its bound, as the theory of intervals asks.
constexpr Parameters covered{1.5, 0.3, 0.8, 0.25, 0.3, 1.2, 0.1, 0.3, 0.3, 0.3, 2, 1, 1, 4};

int cover(const Engine& engine, int trials, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::map<std::string, int> inside;
  int all = 0;
  for (int trial = 0; trial < trials; ++trial) {
    FitProblem problem(engine, synthetic_measurement(covered, 10, 0.5, 0.03, random),
                       options(8, seed + trial));
    const FitSummary summary = summarize(engine, problem, fit(problem), true);
    for (std::size_t v = 0; v < summary.variables.size(); ++v) {
      const double truth = covered.*problem.variables()[v].row().member;
      const auto& interval = summary.variables[v].interval;
      const bool covers = truth >= interval.low && truth <= interval.high;
      inside[summary.variables[v].name] += covers;
      all += covers;
    }
    if ((trial + 1) % 20 == 0) {
      fmt::print(stderr, "{} trials, {:.1f} % covered\n", trial + 1, 100. * all / (14. * (trial + 1)));
    }
  }
  for (const auto& row : parameter_table)
    fmt::print("{:<14} {:5.1f} %\n", row.name, 100. * inside[std::string(row.name)] / trials);
  fmt::print("all            {:5.1f} % of {} intervals\n", 100. * all / (14. * trials), 14 * trials);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const Engine engine(select_device(std::nullopt), Precision::float64, Precision::float32);
  const bool coverage = argc > 1 && std::string(argv[1]) == "coverage";
  const int first = coverage ? 2 : 1;
  const int count = argc > first ? std::atoi(argv[first]) : coverage ? 200 : 20;
  const unsigned seed = argc > first + 1 ? static_cast<unsigned>(std::atoi(argv[first + 1])) : 1;
  return coverage ? cover(engine, count, seed) : recover(engine, count, seed);
}

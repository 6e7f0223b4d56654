#include "host/fit/fit_starts.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <random>
#include <string_view>

namespace brdftab {
namespace {

constexpr std::size_t draws_per_start = 16;
// Their derivatives take memory, so that only so many draws are evaluated together.
constexpr std::size_t draws_at_once = 64;

// The index of a lobe's amplitude in parameter_table.
constexpr std::size_t amplitude_of(std::size_t lobe) {
  constexpr std::string_view prefix = "sigma_";
  std::size_t p = 0;
  while (!parameter_table[p].name.starts_with(prefix) ||
         parameter_table[p].name.substr(prefix.size()) != lobe_names[lobe])
    ++p;
  return p;
}

// Each lobe has a component.
constexpr int lobes = lobe_names.size();
using LobeVector = Eigen::Matrix<double, lobes, 1>;
using LobeMatrix = Eigen::Matrix<double, lobes, lobes>;

Parameters draw(const FitProblem& problem, std::mt19937_64& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * std::generate_canonical<double, 53>(random);
  };
  Parameters parameters{};
  for (std::size_t p = 0; p < parameter_table.size(); ++p) {
    const auto& choice = problem.options().choices[p];
    const ParameterRow& row = parameter_table[p];
    const bool is_low = uniform(0, 1) < row.share_at_low;
    const double drawn =
        is_low ? row.start_low : std::exp(uniform(std::log(row.start_low), std::log(row.start_high)));
    parameters.*row.member = choice.fixed ? *choice.fixed : std::clamp(drawn, choice.minimum, choice.maximum);
  }
  return parameters;
}

// Minimises |A x - b|^2 over x >= 0: the best of all sets of positive unknowns, of which there are few.
LobeVector non_negative(const LobeMatrix& normal, const LobeVector& right,
                        const std::array<bool, lobe_names.size()>& free) {
  LobeVector best = LobeVector::Zero();
  double best_value = 0;
  for (int set = 1; set < 1 << lobes; ++set) {
    std::vector<int> chosen;
    for (int k = 0; k < lobes; ++k)
      if (set >> k & 1) chosen.push_back(k);
    if (std::any_of(chosen.begin(), chosen.end(), [&](int k) { return !free[static_cast<std::size_t>(k)]; }))
      continue;
    const auto count = static_cast<Eigen::Index>(chosen.size());
    Eigen::MatrixXd part(count, count);
    Eigen::VectorXd part_right(count);
    for (Eigen::Index i = 0; i < count; ++i) {
      part_right[i] = right[chosen[static_cast<std::size_t>(i)]];
      for (Eigen::Index j = 0; j < count; ++j)
        part(i, j) = normal(chosen[static_cast<std::size_t>(i)], chosen[static_cast<std::size_t>(j)]);
    }
    const Eigen::VectorXd x = part.ldlt().solve(part_right);
    if (!x.allFinite() || x.minCoeff() < 0) continue;
    const double value = x.dot(part * x) - 2 * x.dot(part_right);
    if (value >= best_value) continue;
    best_value = value;
    best.setZero();
    for (Eigen::Index i = 0; i < count; ++i) best[chosen[static_cast<std::size_t>(i)]] = x[i];
  }
  return best;
}

// Amplitudes that bring the model nearest to the data, in the units of the fit's residuals.
void set_amplitudes(const FitProblem& problem, std::size_t band, const BandValues& values,
                    Parameters& parameters) {
  const FitBand& data = problem.bands()[band];
  LobeMatrix normal = LobeMatrix::Zero();
  LobeVector right = LobeVector::Zero();
  const auto ln_f = values.ln_f();
  std::array<bool, lobe_names.size()> free{};
  for (std::size_t lobe = 0; lobe < lobe_names.size(); ++lobe)
    free[lobe] = !problem.options().choices[amplitude_of(lobe)].fixed;
  for (std::size_t k = 0; k < ln_f.size(); ++k) {
    LobeVector part;
    const double f = std::exp(ln_f[k]) / problem.unit(band, k);
    double target = data.samples[k].brdf / problem.unit(band, k);
    for (std::size_t lobe = 0; lobe < lobe_names.size(); ++lobe) {
      part[static_cast<Eigen::Index>(lobe)] = values.by(amplitude_of(lobe))[k] * f;
      if (!free[lobe])
        target -=
            part[static_cast<Eigen::Index>(lobe)] * (parameters.*parameter_table[amplitude_of(lobe)].member);
    }
    if (!part.allFinite()) continue;
    normal += data.weights[k] * part * part.transpose();
    right += data.weights[k] * target * part;
  }
  const LobeVector solved = non_negative(normal, right, free);
  for (std::size_t lobe = 0; lobe < lobe_names.size(); ++lobe) {
    if (!free[lobe]) continue;
    const auto& choice = problem.options().choices[amplitude_of(lobe)];
    // A lobe without amplitude would have no derivative by its width.
    const double least = 1e-3 * solved.maxCoeff() + 1e-6;
    parameters.*parameter_table[amplitude_of(lobe)].member =
        std::clamp(std::max(solved[static_cast<Eigen::Index>(lobe)], least), choice.minimum, choice.maximum);
  }
}

double cost(const FitProblem& problem, const std::vector<BandValues>& values) {
  double sum = 0;
  for (std::size_t b = 0; b < values.size(); ++b) {
    const auto misfits = problem.misfits(values[b], b);
    for (std::size_t k = 0; k < misfits.size(); ++k)
      sum += problem.bands()[b].weights[k] * misfits[k] * misfits[k];
  }
  return std::isfinite(sum) ? sum : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<std::vector<double>> fit_starts(const FitProblem& problem, std::size_t count,
                                            std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::vector<std::vector<Parameters>> draws;
  for (std::size_t d = 0; d < draws_per_start * count; ++d)
    draws.emplace_back(problem.bands().size(), draw(problem, random));
  std::vector<double> costs;
  for (std::size_t begin = 0; begin < draws.size(); begin += draws_at_once) {
    const std::span part(draws.data() + begin, std::min(draws_at_once, draws.size() - begin));
    const auto bare = problem.batch().evaluate_all(part);
    for (std::size_t d = 0; d < part.size(); ++d)
      for (std::size_t b = 0; b < part[d].size(); ++b) set_amplitudes(problem, b, bare[d][b], part[d][b]);
    for (const auto& values : problem.batch().evaluate_all(part)) costs.push_back(cost(problem, values));
  }
  std::vector<std::size_t> order(draws.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return costs[a] < costs[b]; });
  std::vector<std::vector<double>> starts;
  for (std::size_t k = 0; k < count && std::isfinite(costs[order[k]]); ++k)
    starts.push_back(problem.solver_variables(draws[order[k]]));
  return starts;
}

}  // namespace brdftab

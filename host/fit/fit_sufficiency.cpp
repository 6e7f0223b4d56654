#include "host/fit/fit_sufficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdftab {
namespace {

constexpr double most_of_it = 0.9;

struct Information {
  double theta_i, value;
};

// The part of a column of J that no other column explains, squared, by incidence.
std::vector<Information> information_by_incidence(const FitProblem& problem, const LinearUncertainty& linear,
                                                  Eigen::Index column) {
  Eigen::MatrixXd others = linear.jacobian;
  Eigen::VectorXd own = others.col(column);
  others.col(column).setZero();
  const Eigen::VectorXd lengths = others.colwise().norm().cwiseMax(1e-300);
  const Eigen::MatrixXd scaled = others * lengths.cwiseInverse().asDiagonal();
  own -= scaled * scaled.colPivHouseholderQr().solve(own);
  const Incidences& incidences = problem.incidences();
  std::vector<Information> result;
  for (const double theta_i : incidences.angles()) result.push_back({theta_i, 0});
  Eigen::Index k = 0;
  for (const FitBand& band : problem.bands())
    for (const auto& sample : band.samples) {
      result[incidences.index(sample.pair.theta_i)].value += own[k] * own[k];
      ++k;
    }
  return result;
}

// The shortest run of incidences that holds most of the information.
std::pair<double, double> seen_range(const std::vector<Information>& list) {
  double total = 0;
  for (const auto& [theta_i, value] : list) total += value;
  std::pair<double, double> best{list.front().theta_i, list.back().theta_i};
  std::size_t shortest_run = list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    double sum = 0;
    for (std::size_t j = i; j < list.size(); ++j) {
      sum += list[j].value;
      if (sum < most_of_it * total) continue;
      // Of equally long ones the highest incidences, where shadowing acts.
      if (j - i + 1 <= shortest_run) {
        shortest_run = j - i + 1;
        best = {list[i].theta_i, list[j].theta_i};
      }
      break;
    }
  }
  return best;
}

// What f would be divided by in the residual of a further sample: with sigmas of the data, that of the most
// alike reading.
double expected_unit(const FitProblem& problem, double f) {
  if (!problem.options().take_sigma()) return f;
  if (problem.noise()) return problem.noise()->sigma(f);
  const auto& samples = problem.bands().front().samples;
  return std::min_element(
             samples.begin(), samples.end(),
             [&](const auto& a, const auto& b) { return std::abs(a.brdf - f) < std::abs(b.brdf - f); })
      ->sigma;
}

}  // namespace

std::vector<Sufficiency> sufficiency(const Engine& engine, const FitProblem& problem, const Minimum& best,
                                     const LinearUncertainty& linear,
                                     const std::vector<std::size_t>& variables) {
  if (variables.empty()) return {};
  std::vector<double> incidences;
  for (double theta_i = 0; theta_i <= 85; theta_i += 5) incidences.push_back(theta_i);
  std::vector<DirectionPair> scans;
  for (const double theta_i : incidences)
    for (double theta_s = -80; theta_s <= 80; theta_s += 5) scans.push_back({theta_i, theta_s, 0, 0});
  const std::size_t scan = scans.size() / incidences.size();
  const LogBrdfGradients gradients(engine, scans, problem.share_s(), problem.options().variant);
  // A spectrum is judged by its first band.
  const auto bands = problem.parameters(best.u);
  const LogBrdfValues values = gradients.evaluate({bands.data(), 1});
  std::vector<double> weight;
  for (const double ln_f : values.ln_f(0))
    weight.push_back(std::exp(ln_f) / expected_unit(problem, std::exp(ln_f)));
  const auto count = static_cast<Eigen::Index>(linear.active.size());
  const Eigen::VectorXd lengths = linear.jacobian.colwise().norm();
  const auto inverse_scaled = [&](const Eigen::MatrixXd& jacobian) {
    const Eigen::MatrixXd scaled = jacobian * lengths.cwiseInverse().asDiagonal();
    Eigen::MatrixXd normal = scaled.transpose() * scaled;
    normal.diagonal().array() += 1e-14;
    return Eigen::MatrixXd(normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count)));
  };
  const Eigen::MatrixXd before = inverse_scaled(linear.jacobian);
  std::vector<Eigen::MatrixXd> after;
  for (std::size_t i = 0; i < incidences.size(); ++i) {
    Eigen::MatrixXd extended(linear.jacobian.rows() + static_cast<Eigen::Index>(scan), count);
    extended.topRows(linear.jacobian.rows()) = linear.jacobian;
    for (Eigen::Index a = 0; a < count; ++a) {
      const FitVariable& v = problem.variables()[linear.active[static_cast<std::size_t>(a)]];
      const bool is_first = std::find(v.bands.begin(), v.bands.end(), 0u) != v.bands.end();
      const double slope = v.slope(best.u[linear.active[static_cast<std::size_t>(a)]]);
      for (std::size_t k = 0; k < scan; ++k) {
        const double by = values.by(0, v.parameter)[i * scan + k] * weight[i * scan + k];
        extended(linear.jacobian.rows() + static_cast<Eigen::Index>(k), a) =
            is_first && std::isfinite(by) ? by * slope : 0;
      }
    }
    after.push_back(inverse_scaled(extended));
  }
  std::vector<Sufficiency> result;
  for (const std::size_t variable : variables) {
    const auto column = static_cast<Eigen::Index>(
        std::find(linear.active.begin(), linear.active.end(), variable) - linear.active.begin());
    const auto [from, to] = seen_range(information_by_incidence(problem, linear, column));
    Sufficiency entry{variable, from, to, incidences.front(), 0};
    for (std::size_t i = 0; i < incidences.size(); ++i) {
      const double gain = std::sqrt(before(column, column) / after[i](column, column));
      if (gain > entry.gain) {
        entry.gain = gain;
        entry.helpful_theta_i = incidences[i];
      }
    }
    result.push_back(entry);
  }
  return result;
}

}  // namespace brdftab

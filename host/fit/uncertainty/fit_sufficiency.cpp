#include "host/fit/uncertainty/fit_sufficiency.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brdftab {
namespace {

constexpr double most_of_it = 0.9;

struct Information {
  double theta_i, value;
};

// Squares the part of a column of J that no other column explains, and sums it by incidence.
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

// Finds the shortest run of incidences that holds most of the information.
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
      // Among runs of equal length the one of the highest incidences counts, where shadowing acts.
      if (j - i + 1 <= shortest_run) {
        shortest_run = j - i + 1;
        best = {list[i].theta_i, list[j].theta_i};
      }
      break;
    }
  }
  return best;
}

// The residual of a further sample would divide f by this. Where the data have sigmas, it is the sigma of the
// reading that is most alike.
double expected_unit(const FitProblem& problem, double f) {
  if (!problem.options().take_sigma()) return f;
  if (problem.noise()) return problem.noise()->sigma(f);
  const auto& samples = problem.bands().front().samples;
  return std::min_element(
             samples.begin(), samples.end(),
             [&](const auto& a, const auto& b) { return std::abs(a.brdf - f) < std::abs(b.brdf - f); })
      ->sigma;
}

// In-plane scans that a further measurement might be: theta_s from -80 to 80 by 5 degrees at each theta_i.
class FurtherScans {
 public:
  FurtherScans(const Engine& engine, const FitProblem& problem, const Minimum& best)
      : problem_(problem), best_(best), values_(evaluate(engine)) {
    for (const double ln_f : values_.ln_f(0))
      weight_.push_back(std::exp(ln_f) / expected_unit(problem, std::exp(ln_f)));
  }

  const std::vector<double>& theta_i() const { return theta_i_; }

  /// The derivatives of the fit with those of one scan below them.
  Eigen::MatrixXd extended(const LinearUncertainty& linear, std::size_t scan) const {
    const std::size_t samples = weight_.size() / theta_i_.size();
    const Eigen::Index rows = linear.jacobian.rows();
    Eigen::MatrixXd result(rows + static_cast<Eigen::Index>(samples), linear.jacobian.cols());
    result.topRows(rows) = linear.jacobian;
    for (Eigen::Index a = 0; a < linear.jacobian.cols(); ++a) {
      const std::size_t variable = linear.active[static_cast<std::size_t>(a)];
      const FitVariable& v = problem_.variables()[variable];
      const bool is_first = std::find(v.bands.begin(), v.bands.end(), 0u) != v.bands.end();
      const double slope = v.slope(best_.u[variable]);
      for (std::size_t k = 0; k < samples; ++k) {
        const double by = values_.by(0, v.parameter)[scan * samples + k] * weight_[scan * samples + k];
        result(rows + static_cast<Eigen::Index>(k), a) = is_first && std::isfinite(by) ? by * slope : 0;
      }
    }
    return result;
  }

 private:
  // A spectrum is judged by its first band.
  LogBrdfValues evaluate(const Engine& engine) {
    std::vector<DirectionPair> pairs;
    for (double theta_i = 0; theta_i <= 85; theta_i += 5) {
      theta_i_.push_back(theta_i);
      for (double theta_s = -80; theta_s <= 80; theta_s += 5) pairs.push_back({theta_i, theta_s, 0, 0});
    }
    const LogBrdfGradients gradients(engine, pairs, problem_.share_s(), problem_.options().variant);
    const auto bands = problem_.parameters(best_.u);
    return gradients.evaluate({bands.data(), 1});
  }

  const FitProblem& problem_;
  const Minimum& best_;
  std::vector<double> theta_i_;
  LogBrdfValues values_;
  std::vector<double> weight_;
};

}  // namespace

std::vector<Sufficiency> sufficiency(const Engine& engine, const FitProblem& problem, const Minimum& best,
                                     const LinearUncertainty& linear,
                                     const std::vector<std::size_t>& variables) {
  if (variables.empty()) return {};
  const Eigen::VectorXd lengths = linear.jacobian.colwise().norm();
  const auto inverse_scaled = [&](const Eigen::MatrixXd& jacobian) {
    const Eigen::Index count = jacobian.cols();
    const Eigen::MatrixXd scaled = jacobian * lengths.cwiseInverse().asDiagonal();
    Eigen::MatrixXd normal = scaled.transpose() * scaled;
    normal.diagonal().array() += 1e-14;
    return Eigen::MatrixXd(normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count)));
  };
  const FurtherScans scans(engine, problem, best);
  const Eigen::MatrixXd before = inverse_scaled(linear.jacobian);
  std::vector<Eigen::MatrixXd> after;
  for (std::size_t i = 0; i < scans.theta_i().size(); ++i)
    after.push_back(inverse_scaled(scans.extended(linear, i)));
  std::vector<Sufficiency> result;
  for (const std::size_t variable : variables) {
    const auto column = static_cast<Eigen::Index>(
        std::find(linear.active.begin(), linear.active.end(), variable) - linear.active.begin());
    const auto [from, to] = seen_range(information_by_incidence(problem, linear, column));
    Sufficiency entry{variable, from, to, scans.theta_i().front(), 0};
    for (std::size_t i = 0; i < after.size(); ++i) {
      const double gain = std::sqrt(before(column, column) / after[i](column, column));
      if (gain > entry.gain) {
        entry.gain = gain;
        entry.helpful_theta_i = scans.theta_i()[i];
      }
    }
    result.push_back(entry);
  }
  return result;
}

}  // namespace brdftab

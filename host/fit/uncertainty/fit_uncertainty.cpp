#include "host/fit/uncertainty/fit_uncertainty.hpp"

#include <boost/math/distributions/students_t.hpp>

#include <algorithm>
#include <cmath>

namespace brdftab {
namespace {

// A singular value below this part of the largest is lost in rounding.
constexpr double smallest_singular = 1e-10;

}  // namespace

double student_95(std::size_t degrees_of_freedom) {
  return boost::math::quantile(boost::math::students_t(static_cast<double>(degrees_of_freedom)), 0.975);
}

double LinearUncertainty::standard_error(std::size_t variable) const {
  const auto at = std::find(active.begin(), active.end(), variable);
  if (at == active.end()) return std::numeric_limits<double>::infinity();
  const auto k = static_cast<Eigen::Index>(at - active.begin());
  return std::sqrt(covariance(k, k));
}

LinearUncertainty linear_uncertainty(const FitProblem& problem, const Minimum& best) {
  const auto& variables = problem.variables();
  const auto values = problem.residuals(best.u);
  const auto rows = static_cast<Eigen::Index>(values.values.size());
  const auto columns = static_cast<Eigen::Index>(variables.size());
  using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Eigen::Map<const RowMajor> whole(values.jacobian.data(), rows, columns);
  LinearUncertainty result{};
  for (std::size_t v = 0; v < variables.size(); ++v) {
    const double x = variables[v].from_solver(best.u[v]);
    if (!variables[v].at_minimum(x) && !variables[v].at_maximum(x) &&
        whole.col(static_cast<Eigen::Index>(v)).norm() > 1e-9)
      result.active.push_back(v);
  }
  const auto count = static_cast<Eigen::Index>(result.active.size());
  result.degrees_of_freedom = values.values.size() - std::min(result.active.size(), values.values.size() - 1);
  result.reduced_chi_square = values.cost / static_cast<double>(result.degrees_of_freedom);
  result.variance =
      problem.options().take_sigma() ? std::max(result.reduced_chi_square, 1.) : result.reduced_chi_square;
  result.jacobian.resize(rows, count);
  for (Eigen::Index a = 0; a < count; ++a)
    result.jacobian.col(a) = whole.col(static_cast<Eigen::Index>(result.active[static_cast<std::size_t>(a)]));
  if (count == 0) {
    result.condition = 1;
    return result;
  }
  const Eigen::VectorXd lengths = result.jacobian.colwise().norm();
  const Eigen::MatrixXd scaled = result.jacobian * lengths.cwiseInverse().asDiagonal();
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(scaled);
  const Eigen::MatrixXd r = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(r, Eigen::ComputeFullV);
  const Eigen::VectorXd singular = svd.singularValues().cwiseMax(smallest_singular * svd.singularValues()[0]);
  result.condition = std::pow(singular[0] / singular[count - 1], 2);
  const Eigen::MatrixXd factor = lengths.cwiseInverse().asDiagonal() * svd.matrixV() *
                                 singular.cwiseInverse().asDiagonal() * std::sqrt(result.variance);
  result.covariance = factor * factor.transpose();
  return result;
}

std::vector<double> freedom(const LinearUncertainty& linear) {
  // The covariance is variance (J^T J)^-1.
  std::vector<double> result(static_cast<std::size_t>(linear.jacobian.rows()), 1.);
  if (linear.active.empty()) return result;
  const Eigen::VectorXd leverage =
      (linear.jacobian * linear.covariance).cwiseProduct(linear.jacobian).rowwise().sum();
  for (Eigen::Index k = 0; k < leverage.size(); ++k)
    result[static_cast<std::size_t>(k)] = std::clamp(1 - leverage[k] / linear.variance, 0., 1.);
  return result;
}

std::vector<Interval95> linear_intervals(const FitProblem& problem, const Minimum& best,
                                         const LinearUncertainty& linear) {
  const double t = student_95(linear.degrees_of_freedom);
  std::vector<Interval95> result;
  for (std::size_t v = 0; v < problem.variables().size(); ++v) {
    const FitVariable& variable = problem.variables()[v];
    const double reach = t * linear.standard_error(v);
    const double low = variable.to_solver(variable.minimum);
    const double high = variable.to_solver(variable.maximum);
    const bool open_below = best.u[v] - reach <= low;
    const bool open_above = best.u[v] + reach >= high;
    result.push_back({open_below ? variable.minimum : variable.from_solver(best.u[v] - reach),
                      open_above ? variable.maximum : variable.from_solver(best.u[v] + reach), open_below,
                      open_above});
  }
  return result;
}

}  // namespace brdftab

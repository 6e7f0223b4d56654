#include "host/fit/minimizer.hpp"

#include <ceres/ceres.h>
#include <glog/logging.h>

#include <algorithm>
#include <cmath>

namespace brdftab {
namespace {

// From so many on normal equations are faster than QR, and spectra, which have them, are conditioned well.
constexpr std::size_t many_variables = 40;

class FitResiduals : public ceres::CostFunction {
 public:
  FitResiduals(const FitProblem& problem, std::vector<double> start, std::vector<std::size_t> active)
      : problem_(problem), u_(std::move(start)), active_(std::move(active)) {
    set_num_residuals(static_cast<int>(problem.samples()));
    mutable_parameter_block_sizes()->push_back(static_cast<int>(active_.size()));
  }

  bool Evaluate(double const* const* parameters, double* residuals, double** jacobians) const override {
    for (std::size_t a = 0; a < active_.size(); ++a) u_[active_[a]] = parameters[0][a];
    // Ceres asks for the derivatives where it has just asked for the cost.
    if (u_ != evaluated_at_) {
      evaluated_ = problem_.residuals(u_);
      evaluated_at_ = u_;
    }
    if (!std::isfinite(evaluated_.cost)) return false;
    std::copy(evaluated_.values.begin(), evaluated_.values.end(), residuals);
    if (jacobians && jacobians[0])
      for (std::size_t k = 0; k < evaluated_.values.size(); ++k)
        for (std::size_t a = 0; a < active_.size(); ++a)
          jacobians[0][k * active_.size() + a] = evaluated_.jacobian[k * u_.size() + active_[a]];
    return true;
  }

 private:
  const FitProblem& problem_;
  // Ceres is asked to evaluate in one thread, so that these need no lock.
  mutable std::vector<double> u_;
  mutable std::vector<double> evaluated_at_;
  mutable FitProblem::Residuals evaluated_;
  std::vector<std::size_t> active_;
};

}  // namespace

void silence_solver() { FLAGS_minloglevel = google::GLOG_FATAL; }

Minimum minimize(const FitProblem& problem, std::vector<double> start, const Patience& patience,
                 const std::vector<bool>& held) {
  const auto& variables = problem.variables();
  std::vector<std::size_t> active;
  for (std::size_t v = 0; v < variables.size(); ++v)
    if (held.empty() || !held[v]) active.push_back(v);
  if (active.empty()) return {start, problem.residuals(start).cost, true, 0};
  std::vector<double> x;
  for (const std::size_t v : active)
    x.push_back(std::clamp(start[v], variables[v].to_solver(variables[v].minimum),
                           variables[v].to_solver(variables[v].maximum)));

  ceres::Problem solver;
  solver.AddResidualBlock(new FitResiduals(problem, start, active), nullptr, x.data());
  for (std::size_t a = 0; a < active.size(); ++a) {
    const FitVariable& v = variables[active[a]];
    solver.SetParameterLowerBound(x.data(), static_cast<int>(a), v.to_solver(v.minimum));
    solver.SetParameterUpperBound(x.data(), static_cast<int>(a), v.to_solver(v.maximum));
  }
  ceres::Solver::Options options;
  options.linear_solver_type =
      active.size() < many_variables ? ceres::DENSE_QR : ceres::DENSE_NORMAL_CHOLESKY;
  options.max_num_iterations = patience.iterations;
  options.function_tolerance = patience.tolerance;
  options.gradient_tolerance = 1e-14;
  options.parameter_tolerance = 1e-12;
  options.num_threads = 1;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &solver, &summary);
  Minimum minimum{std::move(start), 2 * summary.final_cost, summary.termination_type == ceres::CONVERGENCE,
                  static_cast<int>(summary.iterations.size())};
  for (std::size_t a = 0; a < active.size(); ++a) minimum.u[active[a]] = x[a];
  if (!summary.IsSolutionUsable() || summary.final_cost < 0)
    minimum.cost = std::numeric_limits<double>::infinity();
  return minimum;
}

}  // namespace brdftab

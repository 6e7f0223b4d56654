// How far a fit is to be believed: standard errors, correlations and intervals of its variables.
#pragma once

#include <Eigen/Dense>

#include <vector>

#include "host/fit/minimizer.hpp"

namespace brdftab {

/// From the derivatives at the minimum. Variables at a bound, and those that the residuals do not depend on,
/// are left out: the solver's bounds know no covariance.
struct LinearUncertainty {
  /// Variance of a residual of weight 1: cost over degrees of freedom. In units of sigma it is at least 1: a
  /// given sigma is believed, unless the misfit is larger.
  double variance;
  double reduced_chi_square;
  std::size_t degrees_of_freedom;
  /// Of the variables left in, in this order, in the solver's variables.
  std::vector<std::size_t> active;
  Eigen::MatrixXd jacobian;
  Eigen::MatrixXd covariance;
  /// Of J^T J with columns of unit length.
  double condition;

  /// Of one variable, in the solver's variables; infinite where it is not active but free to move.
  double standard_error(std::size_t variable) const;
};

LinearUncertainty linear_uncertainty(const FitProblem& problem, const Minimum& best);

/// 1 - leverage of each sample: the part of its noise that the fit has not followed.
std::vector<double> freedom(const LinearUncertainty& linear);

/// A 95 % interval, in the paper's units. Open: the whole way to the bound fits about as well.
struct Interval95 {
  double low;
  double high;
  bool open_below;
  bool open_above;
};

/// By profile likelihood: each variable is moved away from the best, the others follow, until the cost has
/// risen by variance * t^2 (t: Student's, 97.5 %). Where a lower cost turns up on the way, `best` becomes it
/// and all is repeated.
std::vector<Interval95> profile_intervals(const FitProblem& problem, Minimum& best);

/// From standard errors alone, in the solver's variables, cut at the bounds.
std::vector<Interval95> linear_intervals(const FitProblem& problem, const Minimum& best,
                                         const LinearUncertainty& linear);

/// Student's 97.5 % quantile.
double student_95(std::size_t degrees_of_freedom);

}  // namespace brdftab

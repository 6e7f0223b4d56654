// How far a fit is to be believed: standard errors, correlations and intervals of its variables.
#pragma once

#include <Eigen/Dense>

#include <vector>

#include "host/fit/minimizer.hpp"

namespace brdftab {

/// What the derivatives at the minimum say. Variables at a bound are left out, since a covariance knows no
/// bounds, and so are those that the residuals do not depend on.
struct LinearUncertainty {
  /// The variance of a residual of weight 1 is the cost over the degrees of freedom. In units of sigma it is
  /// at least 1: a given sigma is believed, unless the misfit is larger.
  double variance;
  double reduced_chi_square;
  std::size_t degrees_of_freedom;
  /// The variables left in; the matrices are in this order and in the solver's variables.
  std::vector<std::size_t> active;
  Eigen::MatrixXd jacobian;
  Eigen::MatrixXd covariance;
  /// The condition number of J^T J, whose columns have unit length.
  double condition;

  /// The error of one variable, in the solver's units; it is infinite where the variable is not active.
  double standard_error(std::size_t variable) const;
};

LinearUncertainty linear_uncertainty(const FitProblem& problem, const Minimum& best);

/// Gives 1 - leverage of each sample: the part of its noise that the fit has not followed.
std::vector<double> freedom(const LinearUncertainty& linear);

/// A 95 % interval, in the paper's units. It is open where the whole way to the bound fits about as well.
struct Interval95 {
  double low;
  double high;
  bool open_below;
  bool open_above;
};

/// Takes standard errors alone, in the solver's variables, and cuts the intervals at the bounds.
std::vector<Interval95> linear_intervals(const FitProblem& problem, const Minimum& best,
                                         const LinearUncertainty& linear);

/// The 97.5 % quantile of Student's distribution.
double student_95(std::size_t degrees_of_freedom);

}  // namespace brdftab

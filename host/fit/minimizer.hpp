// Ceres on a FitProblem: one descent from one start.
#pragma once

#include <vector>

#include "host/fit/fit_problem.hpp"

namespace brdftab {

struct Minimum {
  std::vector<double> u;  // solver's variables
  double cost;            // sum of squared residuals
  bool converged;
  int iterations;
};

/// How far a descent goes.
struct Patience {
  int iterations = 100;
  /// Relative decrease of the cost in one step that ends it.
  double tolerance = 1e-8;
};

/// Levenberg-Marquardt within the bounds, over the variables that are not `held` (empty: over all).
Minimum minimize(const FitProblem& problem, std::vector<double> start, const Patience& patience,
                 const std::vector<bool>& held = {});

}  // namespace brdftab

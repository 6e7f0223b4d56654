// Ceres minimises a FitProblem: one descent from one start.
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

/// When a descent ends.
struct Patience {
  int iterations = 100;
  /// A step that lowers the cost by no more than this part is the last.
  double tolerance = 1e-8;
};

/// Ceres logs to standard error each step that leaves the model's numbers, and shortens it; nobody needs to
/// read of it. For a program to call once at its start: the level of the log is that of the whole process.
void silence_solver();

/// Levenberg-Marquardt runs within the bounds, over the variables that are not `held` (empty: over all).
Minimum minimize(const FitProblem& problem, std::vector<double> start, const Patience& patience,
                 const std::vector<bool>& held = {});

}  // namespace brdftab

// Fits the fourteen parameters to a measurement: many starts, the best of which is polished.
#pragma once

#include "host/fit/minimizer.hpp"

namespace brdftab {

struct Fit {
  Minimum best;
  std::size_t starts;
  /// Starts that converged, and those of them whose rms ended within 1 % of the best.
  std::size_t converged;
  std::size_t reached;
  /// Wall time of the search, and of the kernels in it.
  double seconds;
  double kernel_seconds;
  std::size_t evaluations;
};

/// Throws Error (exit status 1) where no start converges. Results depend on the options only, not on timing.
Fit fit(FitProblem& problem);

}  // namespace brdftab

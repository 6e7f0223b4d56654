// A fit of the model's parameters to a measurement: many starts descend, and the best are polished.
#pragma once

#include "host/fit/minimizer.hpp"

namespace brdftab {

struct Fit {
  Minimum best;
  std::size_t starts;
  /// How many starts converged, and how many of those ended within 1 % of the best rms.
  std::size_t converged;
  std::size_t reached;
  /// Wall time that the search took, and that the kernels took in it.
  double seconds;
  double kernel_seconds;
  std::size_t evaluations;
};

/// Throws Error (Fault::check) where no start converges. The result depends on the options, never on timing.
Fit fit(FitProblem& problem);

}  // namespace brdftab

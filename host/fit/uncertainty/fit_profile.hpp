// Profile likelihood gives the intervals that remain when the other variables follow.
#pragma once

#include <vector>

#include "host/fit/uncertainty/fit_uncertainty.hpp"

namespace brdftab {

/// Each variable is moved away from the best, the others follow, until the cost has risen by variance * t^2
/// (t: Student's, 97.5 %). Where a lower cost turns up on the way, `best` becomes it and all is repeated.
std::vector<Interval95> profile_intervals(const FitProblem& problem, Minimum& best);

}  // namespace brdftab

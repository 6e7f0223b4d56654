// The starting points of a fit: their shapes are drawn, seeded, and their amplitudes solved for.
#pragma once

#include <vector>

#include "host/fit/fit_problem.hpp"

namespace brdftab {

/// Gives the best `count` of many draws, in the solver's variables. The shapes are drawn over what measured
/// surfaces have; the amplitudes, in which f is linear, then follow from the data of each band by
/// non-negative least squares.
std::vector<std::vector<double>> fit_starts(const FitProblem& problem, std::size_t count, std::uint64_t seed);

}  // namespace brdftab

// What the measurement lacks: which incidences tell a parameter, and which further ones would.
#pragma once

#include "host/fit/uncertainty/fit_uncertainty.hpp"

namespace brdftab {

/// What the measurement says about one variable of a fit.
struct Sufficiency {
  std::size_t variable;
  /// Nine tenths of what the data say about it, and about nothing else, comes from incidences in this range,
  /// degrees.
  double seen_from;
  double seen_to;
  /// The in-plane scan (theta_s from -80 to 80 by 5 degrees) that would narrow it most, and the factor by
  /// which its standard error would shrink.
  double helpful_theta_i;
  double gain;
};

/// Judges the variables given, which must be active in `linear`.
std::vector<Sufficiency> sufficiency(const Engine& engine, const FitProblem& problem, const Minimum& best,
                                     const LinearUncertainty& linear,
                                     const std::vector<std::size_t>& variables);

}  // namespace brdftab

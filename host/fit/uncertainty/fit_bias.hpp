// Leaving out low readings biases a fit: by how much, and where.
#pragma once

#include <optional>
#include <string>

#include "host/fit/fit_problem.hpp"

namespace brdftab {

/// The readings at or below the floor were left out by their measured value, so that what is kept is too high
/// on average.
struct LowReadingsLeftOut {
  /// How many samples were left out, of how many within max_theta.
  std::size_t count, all;
  /// The angle of incidence, in degrees, where the fitted f exceeds the readings most, those left out
  /// included; sums over its samples, weighted by cos theta_s sin theta_s as DHR is over a ring.
  double theta_i;
  double fitted_sum, measured_sum;
};

/// There are none where the floor takes no more than 5 % of the samples.
std::optional<LowReadingsLeftOut> low_readings_left_out(const Engine& engine, const FitProblem& problem,
                                                        const std::vector<Parameters>& bands);

/// Says how many they are, what that does to DHR, and the settings that mend it.
std::string text_of(const LowReadingsLeftOut& low, const FitOptions& options);

}  // namespace brdftab

// The noise of a measurement that gives no sigma: a part in proportion to f and a constant one.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace brdftab {

/// sigma^2 = relative^2 f^2 + floor^2, with f of the model: that of the data would give low readings too much
/// weight, and bias f. R. J. Carroll and D. Ruppert, Transformation and Weighting in Regression (1988),
/// chapters 2 and 3.
struct NoiseModel {
  double relative;
  double floor;  // 1/sr

  /// Standard deviation of a reading, 1/sr.
  double sigma(double f) const;
};

/// What the user says about it; what is absent is estimated.
struct NoiseChoice {
  std::optional<double> relative, floor;

  bool is_given() const { return relative && floor; }
};

/// `RELATIVE,FLOOR` as `2%,1e-3`, or `estimated` for either of them or both. Throws BadInput that names the
/// option.
NoiseChoice noise_choice(const std::string& text);

/// What is absent from the choice by restricted maximum likelihood, given the model's f, the errors, data -
/// f, in 1/sr, and what the fit has left of each sample's freedom: 1 - its leverage. Without it, the bright
/// samples that a fit follows closely would seem to have little noise.
NoiseModel estimated_noise(const NoiseChoice& choice, std::span<const double> f,
                           std::span<const double> errors, std::span<const double> freedom);

/// "sigma^2 = (0.02 f)^2 + (0.001 1/sr)^2, given" and the like.
std::string noise_text(const NoiseModel& noise, const NoiseChoice& choice);

}  // namespace brdftab

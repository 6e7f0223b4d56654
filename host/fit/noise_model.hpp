// The noise of a measurement that gives no sigma: a part in proportion to f and a constant one.
#pragma once

#include <optional>
#include <span>
#include <string>

namespace brdftab {

/// sigma^2 = relative^2 f^2 + floor^2, with f of the model: f of the data would give low readings too much
/// weight and bias the fit. R. J. Carroll and D. Ruppert, Transformation and Weighting in Regression (1988),
/// chapters 2 and 3.
struct NoiseModel {
  double relative;
  double floor;  // 1/sr

  /// The standard deviation of a reading, 1/sr.
  double sigma(double f) const;
};

/// What the user says about it; what is absent is estimated.
struct NoiseChoice {
  std::optional<double> relative, floor;

  bool is_given() const { return relative && floor; }
};

/// Reads RELATIVE,FLOOR as "2%,1e-3", or "estimated" for either of them or both. Throws BadInput that names
/// the setting `noise`.
NoiseChoice noise_choice(const std::string& text);

/// Estimates what is absent from the choice by restricted maximum likelihood, given the model's f, the errors
/// data - f, both 1/sr, and the freedom that the fit has left to each sample: 1 - its leverage. Without it,
/// the bright samples that a fit follows closely would seem to have little noise.
NoiseModel estimated_noise(const NoiseChoice& choice, std::span<const double> f,
                           std::span<const double> errors, std::span<const double> freedom);

/// Says the model in words: "sigma^2 = (a f)^2 + b^2 with f of the model, a = 0.02 given, b = ...".
std::string noise_text(const NoiseModel& noise, const NoiseChoice& choice);

}  // namespace brdftab

// Measurements made by the scalar reference on the paper's geometry: theta_i from 0 to 80 degrees, theta_s in
// plane from -80 to 80.
#pragma once

#include <cmath>
#include <random>

#include "host/model/measurement/measurement.hpp"
#include "host/reference/model.hpp"

namespace brdftab {

/// `noise`: standard deviation of ln f, normally distributed.
inline Measurement synthetic_measurement(const Parameters& parameters, double step_i, double step_s,
                                         double noise, std::mt19937_64& random) {
  const reference::Model model(parameters);
  std::normal_distribution<double> normal;
  Measurement measurement{.source = "synthetic", .channels = {""}, .samples = {}, .warnings = {}};
  for (double theta_i = 0; theta_i <= 80; theta_i += step_i)
    for (double theta_s = -80; theta_s <= 80; theta_s += step_s) {
      MeasuredSample sample{.pair = {theta_i, theta_s, 0, 0}, .brdf = 0};
      const auto f = model.brdf(theta_i, sample.pair.model_theta_s(), sample.pair.model_phi());
      sample.brdf = 0.5 * (f.s.total() + f.p.total()) * std::exp(noise * normal(random));
      measurement.samples.push_back(sample);
    }
  return measurement;
}

}  // namespace brdftab

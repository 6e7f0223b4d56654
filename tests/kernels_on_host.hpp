// The kernels' own maths files compiled as C++, in double and in float: rungs 1 and 2.
#pragma once

#include "host/parameters.hpp"

namespace brdftab::kernels_on_host {

struct Sample {
  double s;
  double p;
};

struct Estimate {
  double value;
  double error;
};

/// f in 1/sr; angles in degrees.
struct Double {
  static Sample brdf(const Parameters&, const ModelSwitches&, double theta_i, double theta_s, double phi);
  static Estimate normalization(const Parameters&, const ModelSwitches&, Lobe, double theta_i);
  /// DHR of a lobe; the error is of their sum, relative.
  static Sample dhr(const Parameters&, const ModelSwitches&, Lobe, double theta_i, double* error = nullptr);
};

struct Float {
  static Sample brdf(const Parameters&, const ModelSwitches&, double theta_i, double theta_s, double phi);
  static Estimate normalization(const Parameters&, const ModelSwitches&, Lobe, double theta_i);
  /// DHR of a lobe; the error is of their sum, relative.
  static Sample dhr(const Parameters&, const ModelSwitches&, Lobe, double theta_i, double* error = nullptr);
};

}  // namespace brdftab::kernels_on_host

// The kernels' own maths compiled as C++, in double and in float: for what is too little work to compile a
// kernel for, and for tests, as rungs 1 and 2 of the ladder.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "host/model/direction_list.hpp"
#include "host/model/parameters.hpp"

namespace brdftab::kernels_on_host {

struct Sample {
  double s;
  double p;
};

struct Estimate {
  double value;
  double error;
};

/// Factors of polar angles: the members of PolarFactors of kernels/model.h in their order, [member][theta],
/// and 1 - E_0 of Eq. (13).
struct PolarTables {
  std::vector<double> factors;
  std::vector<double> incidence_shadowing;
  std::size_t angles() const { return incidence_shadowing.size(); }
  double cosine(std::size_t k) const { return factors[2 * angles() + k]; }
  double v(std::size_t k) const { return factors[3 * angles() + k]; }  // Eq. (10)
};

/// Factors of azimuths: AzimuthFactors of kernels/model.h, as kernels read them, and two of them apart.
struct AzimuthTables {
  std::vector<std::byte> factors;
  std::vector<double> sin2_half;
  std::vector<double> cos2_half;
};

/// In one precision. Angles in degrees.
template <class Real>
struct Kernels {
  /// f in 1/sr of each pair. N is integrated once for each distinct polar angle.
  static std::vector<Sample> brdf(const Parameters&, const Variant&, std::span<const DirectionPair>);
  static Sample brdf(const Parameters& parameters, const Variant& variant, double theta_i, double theta_s,
                     double phi) {
    const DirectionPair pair{theta_i, theta_s, phi};
    return brdf(parameters, variant, {&pair, 1}).front();
  }
  static Estimate normalization(const Parameters&, const Variant&, Lobe, double theta_i);
  /// DHR of a lobe; the error is of their sum, relative.
  static Sample dhr(const Parameters&, const Variant&, Lobe, double theta_i, double* error = nullptr);

  /// ln f, and its derivatives by the parameters in the order of parameter_table; see LogBrdfGradients.
  static std::array<double, 15> log_brdf_gradient(const Parameters&, const Variant&, const DirectionPair&,
                                                  double share_s);
  /// ln N of a lobe, and its derivatives by ln rho, ln w and n.
  static std::array<double, 4> log_normalization_gradient(const Parameters&, Lobe, double theta_i);

  static PolarTables polar_tables(const Parameters&, const Variant&, std::span<const double> theta);
  static AzimuthTables azimuth_tables(std::span<const double> phi);
};

using Double = Kernels<double>;
using Float = Kernels<float>;

}  // namespace brdftab::kernels_on_host

// The structs that kernels share with the host, in both working precisions, and
// the one place where a material becomes them.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>

#include "host/model/parameters.hpp"

namespace brdftab::kernel_f64 {
using scalar = double;
#include "kernels/material_constants.h"
// The second one uses the first.
#include "kernels/gradient_constants.h"
}  // namespace brdftab::kernel_f64

namespace brdftab::kernel_f32 {
using scalar = float;
#include "kernels/material_constants.h"
// The second one uses the first.
#include "kernels/gradient_constants.h"
}  // namespace brdftab::kernel_f32

namespace brdftab {

static_assert(sizeof(kernel_f64::MaterialConstants) == 20 * sizeof(double));
static_assert(sizeof(kernel_f32::MaterialConstants) == 20 * sizeof(float));
static_assert(sizeof(kernel_f64::GradientConstants) == 21 * sizeof(double));
static_assert(kernel_f64::PARAMETER_COUNT == static_cast<int>(parameter_table.size()));
static_assert(sizeof(kernel_f64::ModelVariant) == 5 * sizeof(int));

/// Terms that sum x^k/((a+1)...(a+k)) takes to one part in 8/epsilon; its terms fall from the first for x < a
/// + 1.
inline int series_terms(double a, double x, double epsilon) {
  int k = 0;
  for (double term = 1, sum = 1; term > 0.125 * epsilon * sum; sum += term) term *= x / (a + ++k);
  return k;
}

/// Terms of Legendre's continued fraction, by Lentz's method, until the last changes it by less than epsilon.
inline int fraction_terms(double a, double x, double epsilon) {
  double b = x + 1 - a;
  double c = 1e300;
  double d = 1 / b;
  int k = 0;
  for (double change = 0; std::abs(change - 1) > 0.5 * epsilon && k < 1000;) {
    ++k;
    b += 2;
    d = 1 / (k * (a - k) * d + b);
    c = b + k * (a - k) / c;
    change = c * d;
  }
  return k;
}

/// Constants derived in long double, then rounded once to the kernel's precision.
template <class Constants>
Constants material_constants(const Parameters& p) {
  using Real = decltype(Constants::n_eff);
  const auto real = [](long double value) { return static_cast<Real>(value); };
  const long double n = p.n_eff;
  const long double k = p.k_eff;
  const long double a = 1 + static_cast<long double>(p.n);
  const auto square = [](long double x) { return x * x; };
  // The incomplete gamma function changes its method at x = a + 1, where either converges slowest.
  constexpr double epsilon = std::numeric_limits<Real>::epsilon();
  const auto shape = static_cast<double>(a);
  const double largest_x = shape / (p.w * p.w);
  const double change_x = shape + 1;
  return {
      .n_eff = real(n),
      .k_eff = real(k),
      .m2_re = real((n - k) * (n + k)),
      .m2_im = real(2 * n * k),
      .contrast = real(std::hypot(1 - n, k) * std::hypot(1 + n, k)),
      .sigma_surface = real(p.sigma_surface),
      .sigma_bulk = real(p.sigma_bulk),
      .sigma_retro = real(p.sigma_retro),
      .rho2_surface = real(square(p.rho_surface)),
      .rho2_bulk = real(square(p.rho_bulk)),
      .rho2_retro = real(square(p.rho_retro)),
      .w_a = real(p.w_a),
      .w_b = real(p.w_b),
      .gamma = real(p.gamma),
      .delta = real(p.delta),
      .inverse_w2 = real(1 / square(p.w)),
      .shape = real(a),
      .ln_gamma_scale = real(a * std::log(a) - a - std::lgamma(1 + a)),
      .series_terms = static_cast<Real>(series_terms(shape, std::min(largest_x, change_x), epsilon)),
      .fraction_terms =
          static_cast<Real>(largest_x < change_x ? 0 : fraction_terms(shape, change_x, epsilon)),
  };
}

template <class KernelVariant>
KernelVariant model_variant(const Variant& variant) {
  return {
      .normalization = static_cast<int>(variant.normalization),
      .autocovariance = static_cast<int>(variant.autocovariance),
      .foreshortening = variant.foreshortening,
      .width_shadowing = variant.width_shadowing,
      .reflectance_shadowing = static_cast<int>(variant.reflectance_shadowing),
  };
}

}  // namespace brdftab

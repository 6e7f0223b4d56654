// V_m of Eq. (13). The limits at α = 0 and α₀ = 0 are exact: S = 1 and E₀ = 1.
#include "host/reference/reflectance_shadowing.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab::reference {
namespace {

struct Exponents {
  Real forward;  // −ln E₀
  Real shadow;   // −ln S
  bool ahead;    // α ≥ 0
};

Exponents exponents(const ReflectanceShadowingParameters& parameters, const Direction& in,
                    const Direction& out, double phi) {
  const Real alpha = out.sin * cos_degrees(phi);
  const Real beta = out.sin * sin_degrees(phi);
  return {forward_onset(parameters, in), shadow_exponent(parameters, alpha, out.cos * out.cos + beta * beta),
          alpha >= 0};
}

}  // namespace

Real forward_onset(const ReflectanceShadowingParameters& parameters, const Direction& in) {
  if (in.sin == 0) return 0;
  const Real zeta = in.sin / in.cos;
  return parameters.gamma * std::fabs(zeta) * std::exp(-parameters.delta / (zeta * zeta));
}

Real shadow_exponent(const ReflectanceShadowingParameters& parameters, Real alpha,
                     Real one_minus_alpha_squared) {
  if (alpha == 0) return 0;
  const Real zeta = std::fabs(alpha) / std::sqrt(one_minus_alpha_squared);
  return parameters.w_a * zeta * std::exp(-parameters.w_b / (alpha * alpha));
}

Real reflectance_shadowing(const ReflectanceShadowingParameters& parameters, const Direction& in,
                           const Direction& out, double phi) {
  const Exponents e = exponents(parameters, in, out, phi);
  const Real s = std::exp(-e.shadow);
  return e.ahead ? -std::expm1(-e.forward) + s * std::exp(-e.forward) : s;
}

Real log_reflectance_shadowing(const ReflectanceShadowingParameters& parameters, const Direction& in,
                               const Direction& out, double phi) {
  const Exponents e = exponents(parameters, in, out, phi);
  if (!e.ahead || e.forward == 0) return -e.shadow;
  const Real lit = std::log(-std::expm1(-e.forward));
  const Real shadowed = -e.shadow - e.forward;
  return std::max(lit, shadowed) + std::log1p(std::exp(-std::fabs(lit - shadowed)));
}

}  // namespace brdftab::reference

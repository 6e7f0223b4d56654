// V_m, Eq. (13): masking and shadowing of the reflectance.
#pragma once

#include "host/reference/direction.hpp"

namespace brdftab::reference {

/// Strengths and onsets of Eq. (13).
struct ReflectanceShadowingParameters {
  Real w_a;
  Real w_b;
  Real gamma;
  Real delta;
};

/// −ln E₀ = γ |ζ₀| e^{−δ/ζ₀²}, ζ₀ = tan θ_i: depends on the incidence only.
Real forward_onset(const ReflectanceShadowingParameters& parameters, const Direction& in);

/// −ln S = w_a |ζ| e^{−w_b/α²}, ζ = α/√(1 − α²). 1 − α² is an argument because the
/// caller has it without cancellation: μ_s² + sin²θ_s sin²φ.
Real shadow_exponent(const ReflectanceShadowingParameters& parameters, Real alpha,
                     Real one_minus_alpha_squared);

/// V_m = (1 − E₀) + S E₀ on the forward side (α ≥ 0), S behind.
Real reflectance_shadowing(const ReflectanceShadowingParameters& parameters, const Direction& in,
                           const Direction& out, double phi);

/// ln V_m, which stays finite where V_m underflows.
Real log_reflectance_shadowing(const ReflectanceShadowingParameters& parameters, const Direction& in,
                               const Direction& out, double phi);

}  // namespace brdftab::reference

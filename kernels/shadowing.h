// Masking and shadowing: V of Eq. (10), which narrows a lobe, and V_m of
// Eq. (13), which multiplies its reflectance.
#pragma once
#include "dialect.h"
#include "elementary.h"
#include "incomplete_gamma.h"
#include "material.h"

// V(chi = sin theta), Eq. (10), with n! = Gamma(1 + n).
FN UpperGamma width_shadowing(real sine, MaterialConstants m, ModelVariant variant) {
  UpperGamma v;
  v.value = REAL(1.0);
  v.logarithm = REAL(0.0);
  if (variant.width_shadowing) v = upper_gamma(sine * sine * m.inverse_w2, m);
  return v;
}

// exp(-x) and 1 - exp(-x), each to full precision.
typedef struct {
  real passed;
  real blocked;
} Attenuation;

FN Attenuation attenuation(real exponent) {
  Attenuation a;
  a.passed = exponential(-exponent);
  a.blocked = -exponential_less_1(-exponent);
  return a;
}

// E_0 = exp(-gamma |zeta_0| exp(-delta / zeta_0^2)), zeta_0 = tan theta_i; 1 at theta_i = 0.
FN Attenuation incidence_shadowing(real sine, real cosine, MaterialConstants m) {
  const real zeta = sine / cosine;
  return attenuation(zeta > REAL(0.0) ? m.gamma * zeta * exponential(-m.delta / (zeta * zeta)) : REAL(0.0));
}

// The exponent of S = exp(-w_a |zeta| exp(-w_b / alpha^2)) with alpha = sin theta_s cos phi and
// zeta = alpha / sqrt(1 - alpha^2), where 1 - alpha^2 = cos^2 theta_s + sin^2 theta_s sin^2 phi
// does not cancel; 0 at alpha = 0.
FN_INLINED real scatter_shadowing_exponent(real sine, real cosine, real cos_phi, real sin2_phi,
                                           MaterialConstants m) {
  const real alpha = fabs(sine * cos_phi);
  const real alpha2 = alpha * alpha;
  const real one_minus_alpha2 = fma(sine * sine, sin2_phi, cosine * cosine);
  const real exponent = m.w_a * alpha / sqrt(one_minus_alpha2) * exponential(-m.w_b / alpha2);
  return alpha2 > REAL(0.0) ? exponent : REAL(0.0);
}

FN_INLINED real scatter_shadowing(real sine, real cosine, real cos_phi, real sin2_phi, MaterialConstants m) {
  return exponential(-scatter_shadowing_exponent(sine, cosine, cos_phi, sin2_phi, m));
}

// V_m, Eq. (13): (1 - E_0) + S E_0 on the forward side, alpha >= 0, and S on the other.
FN_INLINED real reflectance_shadowing(Attenuation incidence, real scatter, real cos_phi) {
  return cos_phi >= REAL(0.0) ? fma(scatter, incidence.passed, incidence.blocked) : scatter;
}

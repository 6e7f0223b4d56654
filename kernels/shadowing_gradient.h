// Derivatives of the factors of shadowing.h: of ln V, Eq. (10), and of V_m, Eq. (13).
#pragma once
#include "dialect.h"
#include "elementary.h"
#include "gradient.h"
#include "shadowing.h"

typedef struct {
  real value;
  real logarithm;
  real by_ln_w;      // d ln V / d ln w
  real by_flatness;  // d ln V / d n
} WidthShadowingGradient;

// V = Q(a, a lambda), lambda = sin^2 theta / w^2, as upper_gamma() computes it, each step with its derivative
// by a. By lambda: dQ/dlambda = -a D/lambda, hence dV/d ln w = 2 a D. With x = a lambda and D as there, d ln
// D/da = scale_slope - (lambda - 1 - ln lambda).
FN_SHARED WidthShadowingGradient width_shadowing_gradient(real sine, GradientConstants g,
                                                          ModelVariant variant) {
  WidthShadowingGradient v;
  v.value = REAL(1.0);
  v.logarithm = REAL(0.0);
  v.by_ln_w = REAL(0.0);
  v.by_flatness = REAL(0.0);
  if (!variant.width_shadowing) return v;
  const MaterialConstants m = g.m;
  const scalar a = m.shape;
  const real lambda = sine * sine * m.inverse_w2;
  const real x = a * lambda;
  const real excess = (lambda - REAL(1.0)) - logarithm(lambda);
  const real ln_d = m.ln_gamma_scale - a * excess;
  const real d = exponential(ln_d);
  const real d_slope = g.scale_slope - excess;
  real sum = REAL(1.0);
  real sum_slope = REAL(0.0);
  for (scalar k = m.series_terms; k > SCALAR(0.0); k -= SCALAR(1.0)) {
    const real ratio = x * WIDE(SCALAR(1.0) / (a + k));
    const real ratio_slope = lambda * WIDE(k / ((a + k) * (a + k)));
    sum_slope = fma(sum_slope, ratio, sum * ratio_slope);
    sum = fma(sum, ratio, REAL(1.0));
  }
  const real lower = d * sum;
  v.value = REAL(1.0) - lower;
  v.logarithm = logarithm_1_plus(-lower);
  v.by_ln_w = SCALAR(2.0) * a * d / v.value;
  v.by_flatness = -d * fma(d_slope, sum, sum_slope) / v.value;
  if (m.fraction_terms > SCALAR(0.0)) {
    const real t = REAL(1.0) / x;
    const real t2 = t * t;
    const scalar inverse_a = SCALAR(1.0) / a;
    real denominator_before = REAL(1.0);
    real denominator = fma(t, WIDE(SCALAR(1.0) - a), REAL(1.0));
    real numerator_before = REAL(0.0);
    real numerator = REAL(1.0);
    real denominator_slope_before = REAL(0.0);
    real denominator_slope = -t * inverse_a;
    real numerator_slope_before = REAL(0.0);
    real numerator_slope = REAL(0.0);
    for (scalar k = SCALAR(1.0); k <= m.fraction_terms; k += SCALAR(1.0)) {
      const real partial_numerator = k * (a - k) * t2;
      const real partial_denominator = fma(t, WIDE(SCALAR(2.0) * k + SCALAR(1.0) - a), REAL(1.0));
      const real partial_numerator_slope = k * (SCALAR(2.0) * k - a) * inverse_a * t2;
      const real partial_denominator_slope = -t * (SCALAR(2.0) * k + SCALAR(1.0)) * inverse_a;
      const real next_denominator =
          fma(partial_denominator, denominator, partial_numerator * denominator_before);
      const real next_numerator = fma(partial_denominator, numerator, partial_numerator * numerator_before);
      const real next_denominator_slope =
          fma(partial_denominator, denominator_slope, partial_denominator_slope * denominator) +
          fma(partial_numerator, denominator_slope_before, partial_numerator_slope * denominator_before);
      const real next_numerator_slope =
          fma(partial_denominator, numerator_slope, partial_denominator_slope * numerator) +
          fma(partial_numerator, numerator_slope_before, partial_numerator_slope * numerator_before);
      denominator_before = denominator;
      denominator = next_denominator;
      numerator_before = numerator;
      numerator = next_numerator;
      denominator_slope_before = denominator_slope;
      denominator_slope = next_denominator_slope;
      numerator_slope_before = numerator_slope;
      numerator_slope = next_numerator_slope;
    }
    const real fraction = a * t * numerator / denominator;
    v.value = x < a + SCALAR(1.0) ? v.value : d * fraction;
    v.logarithm = x < a + SCALAR(1.0) ? v.logarithm : ln_d + logarithm(fraction);
    v.by_ln_w = x < a + SCALAR(1.0) ? v.by_ln_w : SCALAR(2.0) * a / fraction;
    v.by_flatness = x < a + SCALAR(1.0)
                        ? v.by_flatness
                        : d_slope + numerator_slope / numerator - denominator_slope / denominator;
  }
  return v;
}

typedef struct {
  real value;
  real by_w_a;
  real by_w_b;
  real by_gamma;
  real by_delta;
} ReflectanceShadowingGradient;

// V_m = 1 - E_0 (1 - S) forward and S backward, S = exp(-w_a onset) and E_0 = exp(-gamma onset_0).
FN ReflectanceShadowingGradient reflectance_shadowing_gradient(real sine_i, real cosine_i, real sine_s,
                                                               real cosine_s, real cos_phi, real sin2_phi,
                                                               MaterialConstants m) {
  MaterialConstants unit = m;
  unit.w_a = SCALAR(1.0);
  const real onset = scatter_shadowing_exponent(sine_s, cosine_s, cos_phi, sin2_phi, unit);
  const real alpha2 = sine_s * cos_phi * sine_s * cos_phi;
  const Attenuation scatter = attenuation(m.w_a * onset);
  const real zeta = sine_i / cosine_i;
  const real onset_i = zeta > REAL(0.0) ? zeta * exponential(-m.delta / (zeta * zeta)) : REAL(0.0);
  const Attenuation incidence = attenuation(m.gamma * onset_i);
  const real s_slope = -scatter.passed * (cos_phi >= REAL(0.0) ? incidence.passed : REAL(1.0));
  const real e_slope = cos_phi >= REAL(0.0) ? incidence.passed * scatter.blocked : REAL(0.0);
  ReflectanceShadowingGradient v;
  v.value = reflectance_shadowing(incidence, scatter.passed, cos_phi);
  v.by_w_a = s_slope * onset;
  v.by_w_b = alpha2 > REAL(0.0) ? -s_slope * m.w_a * onset / alpha2 : REAL(0.0);
  v.by_gamma = e_slope * onset_i;
  v.by_delta = zeta > REAL(0.0) ? -e_slope * m.gamma * onset_i / (zeta * zeta) : REAL(0.0);
  return v;
}

// The regularised upper incomplete gamma function Q(a, a lambda), and its
// logarithm, which stays meaningful where Q underflows.
#pragma once
#include "dialect.h"
#include "elementary.h"
#include "material.h"

typedef struct {
  real value;
  real logarithm;
} UpperGamma;

// a = 1 + n >= 1, lambda >= 0. With x = a lambda, D = x^a e^-x / Gamma(1 + a) = exp(ln_gamma_scale - a
// (lambda - 1 - ln lambda)). Below x = a + 1: Q = 1 - D sum x^k / ((a+1)...(a+k)), all terms positive; above:
// Legendre's continued fraction, whose convergents are ratios of two recurrences, in t = 1/x so that they do
// not overflow. Both run as long as the slowest angle of the material needs: see material_constants(). Q is
// within 2e-15 (1 + |a (lambda - 1 - ln lambda)|).
FN_SHARED UpperGamma upper_gamma(real lambda, MaterialConstants m) {
  const scalar a = m.shape;
  const real x = a * lambda;
  const real ln_d = m.ln_gamma_scale - a * ((lambda - REAL(1.0)) - logarithm(lambda));
  const real d = exponential(ln_d);
  real sum = REAL(1.0);
  for (scalar k = m.series_terms; k > SCALAR(0.0); k -= SCALAR(1.0))
    sum = fma(sum, x * WIDE(SCALAR(1.0) / (a + k)), REAL(1.0));
  const real lower = d * sum;
  UpperGamma q;
  q.value = REAL(1.0) - lower;
  q.logarithm = logarithm_1_plus(-lower);
  if (m.fraction_terms > SCALAR(0.0)) {
    const real t = REAL(1.0) / x;
    const real t2 = t * t;
    real denominator_before = REAL(1.0);
    real denominator = fma(t, WIDE(SCALAR(1.0) - a), REAL(1.0));
    real numerator_before = REAL(0.0);
    real numerator = REAL(1.0);
    for (scalar k = SCALAR(1.0); k <= m.fraction_terms; k += SCALAR(1.0)) {
      const real partial_numerator = k * (a - k) * t2;
      const real partial_denominator = fma(t, WIDE(SCALAR(2.0) * k + SCALAR(1.0) - a), REAL(1.0));
      const real next_denominator =
          fma(partial_denominator, denominator, partial_numerator * denominator_before);
      const real next_numerator = fma(partial_denominator, numerator, partial_numerator * numerator_before);
      denominator_before = denominator;
      denominator = next_denominator;
      numerator_before = numerator;
      numerator = next_numerator;
    }
    const real fraction = a * t * numerator / denominator;
    q.value = x < a + SCALAR(1.0) ? q.value : d * fraction;
    q.logarithm = x < a + SCALAR(1.0) ? q.logarithm : ln_d + logarithm(fraction);
  }
  return q;
}

// The regularised upper incomplete gamma function Q(a, a lambda), and its
// logarithm, which stays meaningful where Q underflows.
#pragma once
#include "dialect.h"

typedef struct {
  real value;
  real logarithm;
} UpperGamma;

// a = 1 + n >= 1, lambda >= 0; ln_scale = ln(a^a e^-a / Gamma(1 + a)).
// With x = a lambda, D = x^a e^-x / Gamma(1 + a) = exp(ln_scale - a (lambda - 1 - ln lambda)).
// Below x = a + 1: Q = 1 - D sum x^k / ((a+1)...(a+k)), all terms positive; above:
// Legendre's continued fraction by Lentz's method.
FN_SHARED UpperGamma upper_gamma(real a, real lambda, real ln_scale)
{
  const real x = a * lambda;
  const real ln_d = ln_scale - a * ((lambda - REAL(1.0)) - log(lambda));
  UpperGamma q;
  if (x < a + REAL(1.0)) {
    real term = REAL(1.0);
    real sum = REAL(1.0);
    for (int k = 1; k < 400 && term > REAL_EPSILON * REAL(0.25) * sum; ++k) {
      term *= x / (a + (real)k);
      sum += term;
    }
    const real lower = exp(ln_d) * sum;
    q.value = REAL(1.0) - lower;
    q.logarithm = log1p(-lower);
  } else {
    real b = x + REAL(1.0) - a;
    real c = REAL(1e30);
    real d = REAL(1.0) / b;
    real fraction = d;
    real change = REAL(0.0);
    for (int k = 1; k < 400 && fabs(change - REAL(1.0)) > REAL_EPSILON; ++k) {
      const real numerator = (real)k * (a - (real)k);
      b += REAL(2.0);
      d = REAL(1.0) / fma(numerator, d, b);
      c = b + numerator / c;
      change = c * d;
      fraction *= change;
    }
    q.value = exp(ln_d) * (a * fraction);
    q.logarithm = ln_d + log(a * fraction);
  }
  return q;
}

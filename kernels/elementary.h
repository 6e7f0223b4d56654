// Exponential and logarithm as plain arithmetic: compilers vectorise it in any loop, which they do to no
// built-in function but exp, and every IEEE device gives the same bits. Errors as measured by
// tests/elementary_test.
#pragma once
#include "dialect.h"

// e^x = 2^n (1 + reduced): x = n ln 2 + r with |r| <= ln(2)/2, ln 2 in two parts; reduced = e^r - 1, whose
// Taylor series ends below 1e-17. x is bounded to the range of normal numbers.
typedef struct {
  real power;  // 2^n
  real reduced;
} ReducedExponential;

FN_INLINED ReducedExponential reduced_exponential(real x) {
  const real bounded = fmin(fmax(x, -EXPONENT_RANGE), EXPONENT_RANGE);
  const real n = rint(bounded * REAL(1.4426950408889634074));
  const real r = fma(n, -LN2_LOW, fma(n, -LN2_HIGH, bounded));
  real p = REAL(1.6059043836821614e-10);
  p = fma(p, r, REAL(2.0876756987868099e-09));
  p = fma(p, r, REAL(2.5052108385441719e-08));
  p = fma(p, r, REAL(2.7557319223985891e-07));
  p = fma(p, r, REAL(2.7557319223985891e-06));
  p = fma(p, r, REAL(2.4801587301587302e-05));
  p = fma(p, r, REAL(1.9841269841269841e-04));
  p = fma(p, r, REAL(1.3888888888888889e-03));
  p = fma(p, r, REAL(8.3333333333333333e-03));
  p = fma(p, r, REAL(4.1666666666666667e-02));
  p = fma(p, r, REAL(1.6666666666666667e-01));
  p = fma(p, r, REAL(0.5));
  ReducedExponential result;
  result.reduced = fma(p, r * r, r);
  // The biased exponent, moved to its place.
  result.power = AS_REAL(AS_BITS(n + WIDE(ROUNDING + EXPONENT_BIAS)) << MANTISSA_BITS);
  return result;
}

// e^x for any x; beyond the range of normal numbers it is 0 or infinite; nan of nan. Within 1 ulp.
FN_INLINED real exponential(real x) {
  const ReducedExponential e = reduced_exponential(x);
  const real value = (e.reduced + REAL(1.0)) * e.power;
  const real bounded = x > EXPONENT_RANGE ? WIDE(INFINITY) : (x < -EXPONENT_RANGE ? REAL(0.0) : value);
  return x == x ? bounded : x;
}

// e^x - 1 without cancellation, for x below EXPONENT_RANGE. Within 2 ulp.
FN_INLINED real exponential_less_1(real x) {
  const ReducedExponential e = reduced_exponential(x);
  const real value = fma(e.reduced, e.power, e.power - REAL(1.0));
  return x == x ? value : x;
}

// ln x of a normal number; 0 counts as the smallest one; nan below 0 and of nan. Within 1 ulp.
// x = 2^e (1 + f) with 1 + f between sqrt(1/2) and sqrt(2), and with s = f/(2 + f),
// ln(1 + f) = 2 s + s R = f - s (f - R), R = 2 s^2/3 + 2 s^4/5 + ..., whose terms end below 1e-17.
FN_INLINED real logarithm(real x) {
  const bits offset = AS_BITS(x) - SQRT_HALF_BITS;
  const bits exponent = offset >> MANTISSA_BITS;
  const real f = AS_REAL(AS_BITS(x) - (exponent << MANTISSA_BITS)) - REAL(1.0);
  const real e = AS_REAL(AS_BITS(WIDE(ROUNDING)) + exponent) - WIDE(ROUNDING);
  const real s = f / (REAL(2.0) + f);
  const real z = s * s;
  real r = REAL(0.08695652173913043478);
  r = fma(r, z, REAL(0.09523809523809523810));
  r = fma(r, z, REAL(0.10526315789473684211));
  r = fma(r, z, REAL(0.11764705882352941176));
  r = fma(r, z, REAL(0.13333333333333333333));
  r = fma(r, z, REAL(0.15384615384615384615));
  r = fma(r, z, REAL(0.18181818181818181818));
  r = fma(r, z, REAL(0.22222222222222222222));
  r = fma(r, z, REAL(0.28571428571428571429));
  r = fma(r, z, REAL(0.4));
  r = fma(r, z, REAL(0.66666666666666666667));
  r *= z;
  const real value = fma(e, LN2_HIGH, f - fma(s, f - r, -e * LN2_LOW));
  const real positive = x < WIDE(INFINITY) ? value : x;
  return x >= REAL(0.0) ? positive : WIDE(NAN);
}

// ln(1 + x) without cancellation, x > -1. Within 2 ulp.
FN_INLINED real logarithm_1_plus(real x) {
  const real sum = REAL(1.0) + x;
  // What the sum lost, to first order.
  return logarithm(sum) + (x - (sum - REAL(1.0))) / sum;
}

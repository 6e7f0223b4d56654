// The exponential as plain arithmetic, which compilers vectorise in any loop; built-in functions they do not.
#pragma once
#include "dialect.h"

// e^x for any x; beyond the range of normal numbers it is 0 or infinite. Measured error: 1 ulp in double and float.
// x = n ln 2 + r with |r| <= ln(2)/2, ln 2 in two parts; the Taylor series of e^r ends below 1e-17.
FN_INLINED real exponential(real x)
{
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
  p = fma(p, r * r, r) + REAL(1.0);
  const real value = p * power_of_two(n);
  return x > EXPONENT_RANGE ? (real)INFINITY : (x < -EXPONENT_RANGE ? REAL(0.0) : value);
}

// Sine and cosine of an angle in degrees. The reduction to [-45, 45] degrees is
// exact, so cos(theta) keeps every digit as theta nears 90 degrees; radians
// would lose three of them at 89.9. Both are within 2 ulp.
#pragma once
#include "dialect.h"

typedef struct {
  real sine;
  real cosine;
} SineCosine;

FN_INLINED SineCosine sincos_degrees(real degrees) {
  const real quarter = rint(degrees * REAL(0.011111111111111111111));
  const real x = fma(quarter, REAL(-90.0), degrees) * REAL(0.017453292519943295769);
  const real x2 = x * x;
  // Taylor series: the first term left out is below 1e-17 for |x| <= pi/4.
  real s = REAL(2.8114572543455206e-15);
  s = fma(s, x2, REAL(-7.6471637318198164e-13));
  s = fma(s, x2, REAL(1.6059043836821614e-10));
  s = fma(s, x2, REAL(-2.5052108385441719e-08));
  s = fma(s, x2, REAL(2.7557319223985891e-06));
  s = fma(s, x2, REAL(-1.9841269841269841e-04));
  s = fma(s, x2, REAL(8.3333333333333333e-03));
  s = fma(s, x2, REAL(-1.6666666666666667e-01));
  const real sine = fma(s * x2, x, x);
  real c = REAL(4.7794773323873853e-14);
  c = fma(c, x2, REAL(-1.1470745597729725e-11));
  c = fma(c, x2, REAL(2.0876756987868099e-09));
  c = fma(c, x2, REAL(-2.7557319223985891e-07));
  c = fma(c, x2, REAL(2.4801587301587302e-05));
  c = fma(c, x2, REAL(-1.3888888888888889e-03));
  c = fma(c, x2, REAL(4.1666666666666667e-02));
  c = fma(c, x2, REAL(-0.5));
  const real cosine = fma(c, x2, REAL(1.0));

  const bits turn = AS_BITS(quarter + WIDE(ROUNDING));
  const real a = (turn & 1) != 0 ? cosine : sine;
  const real b = (turn & 1) != 0 ? sine : cosine;
  SineCosine result;
  result.sine = (turn & 2) != 0 ? -a : a;
  result.cosine = ((turn + 1) & 2) != 0 ? -b : b;
  return result;
}

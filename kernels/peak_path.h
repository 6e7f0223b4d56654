// The path of an integral over u = sin^2 theta_s across the peak of a lobe, and the width of that peak.
#pragma once
#include "dialect.h"
#include "elementary.h"
#include "lobes.h"
#include "material.h"
#include "shadowing.h"

// An integral over u = sin^2 theta_s runs on the two sides of its peak at u = a, over v = |u - a| = h
// sinh(x): the hyperbolic sine takes the peak of width h out of the integrand. A segment of x is mapped by
// z^2 (3 - 2z) from z in [0, 1], which makes square roots at its ends smooth: mu_s at u = 1, the critical
// angle, and sqrt(u) at u = 0.
typedef struct {
  int outer;  // u above a
  real a;
  real mu2_i;
  real h;
  real begin;  // of x
  real length;
} PeakSegment;

typedef struct {
  real v;
  real u;
  real mu_s;
  real jacobian;  // du/dz
} PeakPoint;

FN real side_length(int outer, real a, real mu2_i) { return outer ? mu2_i : a; }

// asinh(v / h)
FN real peak_reach(real v, real h) {
  const real ratio = v / h;
  return logarithm_1_plus(ratio + ratio * ratio / (REAL(1.0) + sqrt(fma(ratio, ratio, REAL(1.0)))));
}

// One side of the peak, whole.
FN PeakSegment peak_side(int outer, real a, real mu2_i, real h) {
  PeakSegment segment;
  segment.outer = outer;
  segment.a = a;
  segment.mu2_i = mu2_i;
  segment.h = h;
  segment.begin = REAL(0.0);
  segment.length = peak_reach(side_length(outer, a, mu2_i), h);
  return segment;
}

FN PeakPoint peak_point(real z, PeakSegment segment) {
  const real x = fma(segment.length, z * z * (REAL(3.0) - REAL(2.0) * z), segment.begin);
  const real grown = exponential(x);
  const real shrunk = REAL(1.0) / grown;
  const real sinh_x = x < REAL(0.5) ? REAL(0.5) * (exponential_less_1(x) - exponential_less_1(-x))
                                    : REAL(0.5) * (grown - shrunk);
  PeakPoint point;
  point.v = fmin(segment.h * sinh_x, side_length(segment.outer, segment.a, segment.mu2_i));
  point.u = segment.outer ? segment.a + point.v : segment.a - point.v;
  // Above 0, where Fresnel's formulas without contrast would be 0/0.
  point.mu_s = sqrt(segment.outer ? fmax(segment.mu2_i - point.v, REAL_EPSILON * segment.mu2_i)
                                  : segment.mu2_i + point.v);
  point.jacobian = segment.h * REAL(3.0) * (grown + shrunk) * segment.length * z * (REAL(1.0) - z);
  return point;
}

// A first step that sees the peak, of unit width in x.
FN real first_step(PeakSegment segment) { return fmin(REAL(0.25), sqrt(REAL(0.5) / segment.length)); }

// The width of a lobe's peak at theta_s = theta_i. Only its logarithm enters an integral, so V may underflow:
// a peak narrower than LN_RHO2_FLOOR is integrated at that width. A Lorentzian peak contributes const - ln
// rho'^2, so ln_missing, the rest of its logarithm, is added; a Gaussian one is proportional to rho'^2.
typedef struct {
  real h;        // half-width of the peak in u
  real ln_rho2;  // ln(rho^2 V(sin theta_i))
  real floor;    // added to rho'^2, where the peak is too narrow
  real ln_missing;
} PeakWidth;

FN PeakWidth peak_width(real sine, real cosine, real rho2, MaterialConstants m, ModelVariant variant) {
  const real ln_v_i = width_shadowing(sine, m, variant).logarithm;
  const real ln_peak = logarithm(rho2 * foreshortening2(cosine, cosine, variant)) + REAL(2.0) * ln_v_i;
  PeakWidth width;
  width.ln_missing = fmax(LN_RHO2_FLOOR - ln_peak, REAL(0.0));
  width.ln_rho2 = logarithm(rho2) + ln_v_i;
  const real p = exponential(ln_peak + width.ln_missing);
  width.floor = p - exponential(ln_peak);
  width.h = sqrt(p * fma(REAL(4.0) * sine, sine, p));
  return width;
}

// rho'^2 at a point of the integral.
FN real integrated_rho2(PeakPoint point, real cosine_i, PeakWidth width, MaterialConstants m,
                        ModelVariant variant) {
  const real ln_v_s = width_shadowing(sqrt(point.u), m, variant).logarithm;
  return fma(foreshortening2(cosine_i, point.mu_s, variant), exponential(width.ln_rho2 + ln_v_s),
             width.floor);
}

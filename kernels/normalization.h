// N of a lobe, which normalises the bare lobe over the hemisphere in direction
// cosines: 1/N = integral of the profile over alpha^2 + beta^2 <= 1. Eqs. (8), (9), (12).
#pragma once
#include "dialect.h"
#include "lobes.h"
#include "material.h"
#include "quadrature.h"
#include "shadowing.h"

typedef struct {
  real value;
  real error;  // relative, estimated
} Normalization;

// Eq. (8), for constant rho, in the form that does not cancel for large rho:
// with R = sqrt((mu^2 + rho^2)^2 + 4 a rho^2) and a = sin^2 theta_i, the argument of the
// logarithm is 1 + 2/(R + rho^2 - mu^2) = (mu^2 + rho^2 + R)/(2 rho^2).
FN real closed_form_normalization(real sine, real cosine, real rho2)
{
  const real mu2 = cosine * cosine;
  const real sum = mu2 + rho2;
  const real root = sqrt(fma(sum, sum, REAL(4.0) * sine * sine * rho2));
  const real half_integral = rho2 >= mu2 ? logarithm_1_plus(REAL(2.0) / (root + (rho2 - mu2)))
                                           : logarithm((sum + root) / (REAL(2.0) * rho2));
  return REAL(1.0) / (PI * half_integral);
}

// exp(-x) I_0(x), x >= 0: power series, and the asymptotic one from x = 20 on,
// whose smallest term is e^-40. All terms are positive.
FN real scaled_bessel_i0(real x)
{
  real term = REAL(1.0);
  real sum = REAL(1.0);
  if (x < REAL(20.0)) {
    for (int k = 1; k < 100 && term > REAL_EPSILON * REAL(0.25) * sum; ++k) {
      term *= REAL(0.25) * x * x / ((real)k * (real)k);
      sum += term;
    }
    return exponential(-x) * sum;
  }
  for (int k = 1; k < 40 && term > REAL_EPSILON * REAL(0.25) * sum; ++k) {
    const real odd = (real)(2 * k - 1);
    term *= odd * odd / (REAL(8.0) * (real)k * x);
    sum += term;
  }
  return sum / sqrt(REAL(2.0) * PI * x);
}

// The integral over phi of the profile, divided by pi, per du with u = sin^2 theta_s.
// Lorentzian: 1/sqrt((u - a)^2 + 2 p (u + a) + p^2), p = rho'^2, whose terms are all positive.
// Gaussian: exponential(-(sqrt(u) - sqrt(a))^2/(4 p)) e^-x I_0(x), x = sqrt(u a)/(2 p).
FN real azimuthal_profile(real v, real u, real a, real p, ModelVariant variant)
{
  if (variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN)
    return REAL(1.0) / sqrt(fma(v, v, p * fma(REAL(2.0), u + a, p)));
  const real difference = v / (sqrt(u) + sqrt(a));
  p = fmax(p, REAL_SMALLEST);
  return exponential(-difference * difference / (REAL(4.0) * p)) * scaled_bessel_i0(sqrt(u * a) / (REAL(2.0) * p));
}

// An integral over u = sin^2 theta_s runs on the two sides of its peak at u = a, over v = |u - a| = h sinh(x): the
// hyperbolic sine takes the peak of width h out of the integrand. A segment of x is mapped by
// z^2 (3 - 2z) from z in [0, 1], which makes square roots at its ends smooth: mu_s at u = 1, the critical angle,
// and sqrt(u) at u = 0.
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

FN real side_length(int outer, real a, real mu2_i)
{
  return outer ? mu2_i : a;
}

// asinh(v / h)
FN real peak_reach(real v, real h)
{
  const real ratio = v / h;
  return logarithm_1_plus(ratio + ratio * ratio / (REAL(1.0) + sqrt(fma(ratio, ratio, REAL(1.0)))));
}

// One side of the peak, whole.
FN PeakSegment peak_side(int outer, real a, real mu2_i, real h)
{
  PeakSegment segment;
  segment.outer = outer;
  segment.a = a;
  segment.mu2_i = mu2_i;
  segment.h = h;
  segment.begin = REAL(0.0);
  segment.length = peak_reach(side_length(outer, a, mu2_i), h);
  return segment;
}

FN PeakPoint peak_point(real z, PeakSegment segment)
{
  const real x = fma(segment.length, z * z * (REAL(3.0) - REAL(2.0) * z), segment.begin);
  const real grown = exponential(x);
  const real shrunk = REAL(1.0) / grown;
  const real sinh_x = x < REAL(0.5) ? REAL(0.5) * (exponential_less_1(x) - exponential_less_1(-x)) : REAL(0.5) * (grown - shrunk);
  PeakPoint point;
  point.v = fmin(segment.h * sinh_x, side_length(segment.outer, segment.a, segment.mu2_i));
  point.u = segment.outer ? segment.a + point.v : segment.a - point.v;
  // Above 0, where Fresnel's formulas without contrast would be 0/0.
  point.mu_s = sqrt(segment.outer ? fmax(segment.mu2_i - point.v, REAL_EPSILON * segment.mu2_i) : segment.mu2_i + point.v);
  point.jacobian = segment.h * REAL(3.0) * (grown + shrunk) * segment.length * z * (REAL(1.0) - z);
  return point;
}

// A first step that sees the peak, of unit width in x.
FN real first_step(PeakSegment segment)
{
  return fmin(REAL(0.25), sqrt(REAL(0.5) / segment.length));
}

// The width of a lobe's peak at theta_s = theta_i. Only its logarithm enters an integral, so V may underflow: a peak
// narrower than LN_RHO2_FLOOR is integrated at that width. A Lorentzian peak contributes const - ln rho'^2, so
// ln_missing, the rest of its logarithm, is added; a Gaussian one is proportional to rho'^2.
typedef struct {
  real h;           // half-width of the peak in u
  real ln_rho2;     // ln(rho^2 V(sin theta_i))
  real floor;       // added to rho'^2, where the peak is too narrow
  real ln_missing;
} PeakWidth;

FN PeakWidth peak_width(real sine, real cosine, real rho2, MaterialConstants m, ModelVariant variant)
{
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
FN real integrated_rho2(PeakPoint point, real cosine_i, PeakWidth width, MaterialConstants m, ModelVariant variant)
{
  const real ln_v_s = width_shadowing(sqrt(point.u), m, variant).logarithm;
  return fma(foreshortening2(cosine_i, point.mu_s, variant), exponential(width.ln_rho2 + ln_v_s), width.floor);
}

// N of one lobe at theta_i.
FN_SHARED Normalization normalization(SineCosine incidence, int lobe, MaterialConstants m, ModelVariant variant)
{
  const real rho2 = lobe_rho2(lobe, m);
  const real mu2_i = incidence.cosine * incidence.cosine;
  const real a = incidence.sine * incidence.sine;
  Normalization result;
  result.error = REAL(0.0);
  if (variant.normalization == NORMALIZATION_CLOSED_FORM) {
    result.value = closed_form_normalization(incidence.sine, incidence.cosine, rho2);
    return result;
  }

  const PeakWidth width = peak_width(incidence.sine, incidence.cosine, rho2, m, variant);
  real integral = variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN ? width.ln_missing : REAL(0.0);
  real error = REAL(0.0);
  for (int outer = 0; outer < 2; ++outer) {
    const PeakSegment segment = peak_side(outer, a, mu2_i, width.h);
    if (!(segment.length > REAL(0.0)))
      continue;
    March march = march_begin(first_step(segment));
    while (march_unfinished(march)) {
      real kronrod = REAL(0.0);
      real gauss = REAL(0.0);
      for (int k = 0; k < PANEL_NODES; ++k) {
        const PeakPoint point = peak_point(fma(march.step, panel_node[k], march.position), segment);
        const real p = integrated_rho2(point, incidence.cosine, width, m, variant);
        const real value = point.jacobian * azimuthal_profile(point.v, point.u, a, p, variant);
        kronrod = fma(kronrod_weight[k], value, kronrod);
        gauss = fma(gauss_weight[k], value, gauss);
      }
      march = march_advance(march, kronrod, gauss, REAL(0.125), PANEL_TOLERANCE, REAL(0.0));
    }
    integral += march.integral;
    error += march.error;
  }
  const real scale = variant.autocovariance == AUTOCOVARIANCE_GAUSSIAN ? exponential(width.ln_missing) : REAL(1.0);
  result.value = scale / (PI * integral);
  result.error = error / integral;
  return result;
}

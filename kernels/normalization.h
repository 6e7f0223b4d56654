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
  const real logarithm = rho2 >= mu2 ? log1p(REAL(2.0) / (root + (rho2 - mu2)))
                                     : log((sum + root) / (REAL(2.0) * rho2));
  return REAL(1.0) / (PI * logarithm);
}

// The integral over phi of the profile, divided by pi, per du with u = sin^2 theta_s.
// Lorentzian: 1/sqrt((u - a)^2 + 2 p (u + a) + p^2), p = rho'^2, whose terms are all positive.
// Gaussian: exp(-(sqrt(u) - sqrt(a))^2/(4 p)) e^-x I_0(x), x = sqrt(u a)/(2 p).
FN real azimuthal_profile(real v, real u, real a, real p, ModelVariant variant)
{
  if (variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN)
    return REAL(1.0) / sqrt(fma(v, v, p * fma(REAL(2.0), u + a, p)));
  const real difference = v / (sqrt(u) + sqrt(a));
  p = fmax(p, REAL_SMALLEST);
  return exp(-difference * difference / (REAL(4.0) * p)) * scaled_bessel_i0(sqrt(u * a) / (REAL(2.0) * p));
}

// A point of the half-integral on one side of the peak at u = a: v = |u - a| = h sinh(x),
// x = reach (1 - (1 - z)^2), z in [0, 1]. The hyperbolic sine takes the peak of width h
// out of the integrand; the square makes mu_s, which ends in a square root of 1 - u, smooth.
typedef struct {
  real v;
  real u;
  real mu_s;
  real jacobian;  // du/dz
} PeakPoint;

FN PeakPoint peak_point(real z, int outer, real a, real mu2_i, real h, real reach)
{
  const real rest = REAL(1.0) - z;
  const real grown = exp(reach * z * (REAL(2.0) - z));
  const real shrunk = REAL(1.0) / grown;
  const real x = reach * z * (REAL(2.0) - z);
  const real sinh_x = x < REAL(0.5) ? REAL(0.5) * (expm1(x) - expm1(-x)) : REAL(0.5) * (grown - shrunk);
  const real end = outer ? mu2_i : a;
  PeakPoint point;
  point.v = fmin(h * sinh_x, end);
  point.u = outer ? a + point.v : a - point.v;
  point.mu_s = sqrt(outer ? mu2_i - point.v : mu2_i + point.v);
  point.jacobian = h * REAL(0.5) * (grown + shrunk) * REAL(2.0) * reach * rest;
  return point;
}

FN real peak_reach(real end, real h)
{
  const real ratio = end / h;
  return log1p(ratio + ratio * ratio / (REAL(1.0) + sqrt(fma(ratio, ratio, REAL(1.0)))));
}

// N of one lobe at theta_i. Only ln rho'^2 enters, so V may underflow: a peak narrower than
// LN_RHO2_FLOOR is integrated at that width, and the rest of its logarithm added, since a
// Lorentzian peak contributes -ln rho'^2 + const (the Gaussian one has no such limit: there N overflows).
FN Normalization normalization(SineCosine incidence, int lobe, MaterialConstants m, ModelVariant variant)
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

  const real ln_v_i = width_shadowing(incidence.sine, m, variant).logarithm;
  const real ln_peak = log(rho2 * foreshortening2(incidence.cosine, incidence.cosine, variant)) + REAL(2.0) * ln_v_i;
  const real ln_missing = fmax(LN_RHO2_FLOOR - ln_peak, REAL(0.0));
  const real ln_width = log(rho2) + ln_v_i + ln_missing;
  const real p_peak = exp(ln_peak + ln_missing);
  const real h = sqrt(p_peak * fma(REAL(4.0), a, p_peak));

  real integral = variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN ? ln_missing : REAL(0.0);
  real error = REAL(0.0);
  for (int outer = 0; outer < 2; ++outer) {
    const real end = outer ? mu2_i : a;
    if (end <= REAL(0.0))
      continue;
    const real reach = peak_reach(end, h);
    const real largest_step = REAL(0.25);
    March march = march_begin(fmin(largest_step, REAL(1.0) / reach));
    while (march_unfinished(march)) {
      real kronrod = REAL(0.0);
      real gauss = REAL(0.0);
      for (int k = 0; k < PANEL_NODES; ++k) {
        const PeakPoint point = peak_point(fma(march.step, panel_node[k], march.position), outer, a, mu2_i, h, reach);
        const real ln_v_s = width_shadowing(sqrt(point.u), m, variant).logarithm;
        const real p = foreshortening2(incidence.cosine, point.mu_s, variant) * exp(ln_width + ln_v_s);
        const real value = point.jacobian * azimuthal_profile(point.v, point.u, a, p, variant);
        kronrod = fma(kronrod_weight[k], value, kronrod);
        gauss = fma(gauss_weight[k], value, gauss);
      }
      march = march_advance(march, kronrod, gauss, largest_step, PANEL_TOLERANCE);
    }
    integral += march.integral;
    error += march.error;
  }
  result.value = REAL(1.0) / (PI * integral);
  result.error = error / integral;
  return result;
}

// N of a lobe, which normalises the bare lobe over the hemisphere in direction
// cosines: 1/N = integral of the profile over alpha^2 + beta^2 <= 1. Eqs. (8), (9), (12).
#pragma once
#include "dialect.h"
#include "lobes.h"
#include "material.h"
#include "peak_path.h"
#include "quadrature.h"
#include "shadowing.h"

typedef struct {
  real value;
  real error;  // relative, estimated
} Normalization;

// Eq. (8), for constant rho, in the form that does not cancel for large rho:
// with R = sqrt((mu^2 + rho^2)^2 + 4 a rho^2) and a = sin^2 theta_i, the argument of the
// logarithm is 1 + 2/(R + rho^2 - mu^2) = (mu^2 + rho^2 + R)/(2 rho^2).
FN real closed_form_normalization(real sine, real cosine, real rho2) {
  const real mu2 = cosine * cosine;
  const real sum = mu2 + rho2;
  const real root = sqrt(fma(sum, sum, REAL(4.0) * sine * sine * rho2));
  const real half_integral = rho2 >= mu2 ? logarithm_1_plus(REAL(2.0) / (root + (rho2 - mu2)))
                                         : logarithm((sum + root) / (REAL(2.0) * rho2));
  return REAL(1.0) / (PI * half_integral);
}

// exp(-x) I_0(x), x >= 0: power series, and the asymptotic one from x = 20 on,
// whose smallest term is e^-40. All terms are positive.
FN real scaled_bessel_i0(real x) {
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
FN real azimuthal_profile(real v, real u, real a, real p, ModelVariant variant) {
  if (variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN)
    return REAL(1.0) / sqrt(fma(v, v, p * fma(REAL(2.0), u + a, p)));
  const real difference = v / (sqrt(u) + sqrt(a));
  p = fmax(p, REAL_SMALLEST);
  return exponential(-difference * difference / (REAL(4.0) * p)) *
         scaled_bessel_i0(sqrt(u * a) / (REAL(2.0) * p));
}

// N of one lobe at theta_i.
FN_SHARED Normalization normalization(SineCosine incidence, int lobe, MaterialConstants m,
                                      ModelVariant variant) {
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
    if (!(segment.length > REAL(0.0))) continue;
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
  const real scale =
      variant.autocovariance == AUTOCOVARIANCE_GAUSSIAN ? exponential(width.ln_missing) : REAL(1.0);
  result.value = scale / (PI * integral);
  result.error = error / integral;
  return result;
}

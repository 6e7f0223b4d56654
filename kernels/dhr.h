// Directional-hemispherical reflectance of a lobe, DHR = integral of f cos theta_s d omega: in direction
// cosines, the integral over u = sin^2 theta_s in [0, 1] and phi in [0, pi] of f.
#pragma once
#include "dialect.h"
#include "model.h"
#include "normalization.h"
#include "quadrature.h"

typedef struct {
  real s;
  real p;
  real error;  // relative, estimated, of s + p
} Dhr;

// What the integral over phi at one theta_s needs: c = axial + rho'^2 and t = transverse of the lobe's
// distance.
typedef struct {
  real sine_s;
  real cosine_s;
  real axial;
  real transverse;
  real rho2;
  int lobe;
  Attenuation incidence;
} Ring;

// V_m at tan(phi/2) = tangent measured from the lobe's centre, at phi = 0, or pi for the retro lobe.
FN_INLINED real ring_shadowing(Ring ring, real tangent, MaterialConstants m, ModelVariant variant) {
  if (!lobe_is_shadowed(ring.lobe, variant)) return REAL(1.0);
  const real t2 = tangent * tangent;
  const real scale = REAL(1.0) / (REAL(1.0) + t2);
  const real toward = (REAL(1.0) - t2) * scale;
  const real sin_phi = REAL(2.0) * tangent * scale;
  const real cos_phi = ring.lobe == LOBE_RETRO ? -toward : toward;
  return reflectance_shadowing(
      ring.incidence, scatter_shadowing(ring.sine_s, ring.cosine_s, cos_phi, sin_phi * sin_phi, m), cos_phi);
}

// V_m times the profile, per d tangent. With T = tan(phi/2) and c = axial + rho'^2,
// d phi/(c + t sin^2(phi/2)) = 2 dT/(c + (c + t) T^2).
FN_INLINED real ring_integrand(Ring ring, real tangent, MaterialConstants m, ModelVariant variant) {
  const real t2 = tangent * tangent;
  const real v_m = ring_shadowing(ring, tangent, m, variant);
  if (variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN) {
    const real c = ring.axial + ring.rho2;
    return v_m * REAL(2.0) / fma(c + ring.transverse, t2, c);
  }
  const real d2 = fma(ring.transverse, t2 / (REAL(1.0) + t2), ring.axial);
  return v_m * exponential(REAL(-0.25) * d2 / ring.rho2) * REAL(2.0) / (REAL(1.0) + t2);
}

// Over phi in [0, pi]. The half nearer to the lobe's centre, T = width sinh(y) in [0, 1], holds the peak;
// the other, 1/T in [0, 1], is smooth. They meet at phi = pi/2, where V_m has its kink.
FN_SHARED real ring_integral(Ring ring, MaterialConstants m, ModelVariant variant) {
  const real c = ring.axial + ring.rho2;
  const real width = variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN
                         ? sqrt(c / (c + ring.transverse))
                         : sqrt(ring.rho2 / (ring.rho2 + ring.transverse));
  const real reach = peak_reach(REAL(1.0), width);
  // What passes where V_m is all but zero: DHR is right to 1e-8 above 1e-12, below that it is not refined.
  const real negligible = NEGLIGIBLE_DHR / sqrt(c * (c + ring.transverse));
  real integral = REAL(0.0);
  for (int far = 0; far < 2; ++far) {
    March march = march_begin(far ? REAL(0.5) : fmin(REAL(0.25), REAL(2.0) / reach));
    march.integral = integral;
    while (march_unfinished(march)) {
      // In loops apart from the sums, so that compilers vectorise them.
      real tangent[PANEL_NODES + 1];
      real value[PANEL_NODES + 1];
      for (int k = 0; k < PANEL_NODES + 1; ++k) {
        const real z = fma(march.step, panel_node[k], march.position);
        if (far) {
          tangent[k] = REAL(1.0) / z;
          value[k] = tangent[k] * tangent[k];
        } else {
          const real grown = exponential(reach * z);
          const real shrunk = REAL(1.0) / grown;
          tangent[k] = fmin(width * REAL(0.5) * (grown - shrunk), REAL(1.0));
          value[k] = reach * width * REAL(0.5) * (grown + shrunk);
        }
      }
      for (int k = 0; k < PANEL_NODES + 1; ++k) value[k] *= ring_integrand(ring, tangent[k], m, variant);
      real kronrod = REAL(0.0);
      real gauss = REAL(0.0);
      for (int k = 0; k < PANEL_NODES; ++k) {
        kronrod = fma(kronrod_weight[k], value[k], kronrod);
        gauss = fma(gauss_weight[k], value[k], gauss);
      }
      march = march_advance(march, kronrod, gauss, REAL(0.5), RING_TOLERANCE, negligible);
    }
    integral = march.integral;
  }
  return integral;
}

// Where the Fresnel factors bend: sqrt(R_p) at the Brewster angle, where |(m^2 + 1) cos^2 - 1| is least, and
// both at the critical angle, Re(m^2 - sin^2) = 0. In u; outside (0, 1) there is none.
typedef struct {
  real brewster;
  real critical;
} FresnelBends;

FN FresnelBends fresnel_bends(MaterialConstants m) {
  const real re = m.m2_re + REAL(1.0);
  FresnelBends bends;
  bends.brewster = REAL(1.0) - re / fma(re, re, m.m2_im * m.m2_im);
  bends.critical = m.m2_re;
  return bends;
}

// v of a bend, if it lies inside that side of the peak; otherwise the side's end.
FN real bend_on_side(real bend, int outer, real a, real end) {
  const real v = outer ? bend - a : a - bend;
  return v > REAL(0.0) && v < end ? v : end;
}

// The reflectance of a ring of scatter directions, per dz.
typedef struct {
  real s;
  real p;
} Reflected;

FN_SHARED Reflected reflected(PeakPoint point, PolarFactors incidence, Ring ring, PeakWidth width, real n_i,
                              MaterialConstants m, ModelVariant variant) {
  ring.sine_s = sqrt(point.u);
  ring.cosine_s = point.mu_s;
  const real difference = point.v / (ring.sine_s + incidence.sine);
  ring.axial = difference * difference;
  ring.transverse = REAL(4.0) * ring.sine_s * incidence.sine;
  ring.rho2 = fmax(integrated_rho2(point, incidence.cosine, width, m, variant), REAL_SMALLEST);
  real n = n_i;
  if (variant.normalization == NORMALIZATION_RECIPROCAL) {
    SineCosine scatter;
    scatter.sine = ring.sine_s;
    scatter.cosine = ring.cosine_s;
    n = pair_normalization(n_i, normalization(scatter, ring.lobe, m, variant).value, variant);
  }
  const PolarizedReflectances reflectance =
      polarized_reflectances(incidence.fresnel, fresnel(ring.sine_s, ring.cosine_s, m));
  const real value = point.jacobian * n * ring_integral(ring, m, variant);
  Reflected result;
  result.s = value * lobe_amplitude(ring.lobe, reflectance.s, m);
  result.p = value * lobe_amplitude(ring.lobe, reflectance.p, m);
  return result;
}

// DHR of one lobe at theta_i, N = n_i included. The outer integral runs like N's, over the two sides of the
// peak.
FN Dhr dhr(PolarFactors incidence, int lobe, real n_i, MaterialConstants m, ModelVariant variant) {
  const real rho2 = lobe_rho2(lobe, m);
  const real mu2_i = incidence.cosine * incidence.cosine;
  const real a = incidence.sine * incidence.sine;
  const PeakWidth width = peak_width(incidence.sine, incidence.cosine, rho2, m, variant);
  Ring ring;
  ring.lobe = lobe;
  ring.incidence = incidence_shadowing(incidence.sine, incidence.cosine, m);

  real total_s = REAL(0.0);
  real total_p = REAL(0.0);
  real error = REAL(0.0);
  // A peak too narrow to resolve: what normalization() adds to its logarithm, weighted as the peak is.
  if (variant.autocovariance == AUTOCOVARIANCE_GAUSSIAN) {
    n_i *= exponential(-width.ln_missing);
  } else if (width.ln_missing > REAL(0.0)) {
    ring.sine_s = incidence.sine;
    ring.cosine_s = incidence.cosine;
    const PolarizedReflectances reflectance = polarized_reflectances(incidence.fresnel, incidence.fresnel);
    const real weight = PI * width.ln_missing * n_i * ring_shadowing(ring, REAL(0.0), m, variant);
    total_s = weight * lobe_amplitude(lobe, reflectance.s, m);
    total_p = weight * lobe_amplitude(lobe, reflectance.p, m);
  }
  const FresnelBends bends = fresnel_bends(m);
  for (int outer = 0; outer < 2; ++outer) {
    const real end = side_length(outer, a, mu2_i);
    if (!(end > REAL(0.0))) continue;
    const real brewster = bend_on_side(bends.brewster, outer, a, end);
    const real critical = bend_on_side(bends.critical, outer, a, end);
    const real stops[3] = {fmin(brewster, critical), fmax(brewster, critical), end};
    PeakSegment segment = peak_side(outer, a, mu2_i, width.h);
    for (int stop = 0; stop < 3; ++stop) {
      segment.length = peak_reach(stops[stop], width.h) - segment.begin;
      if (!(segment.length > REAL(0.0))) continue;
      March march = march_begin(first_step(segment));
      march.integral = total_s + total_p;
      while (march_unfinished(march)) {
        real kronrod_s = REAL(0.0);
        real kronrod_p = REAL(0.0);
        real gauss = REAL(0.0);
        for (int k = 0; k < PANEL_NODES; ++k) {
          const PeakPoint point = peak_point(fma(march.step, panel_node[k], march.position), segment);
          const Reflected value = reflected(point, incidence, ring, width, n_i, m, variant);
          kronrod_s = fma(kronrod_weight[k], value.s, kronrod_s);
          kronrod_p = fma(kronrod_weight[k], value.p, kronrod_p);
          gauss = fma(gauss_weight[k], value.s + value.p, gauss);
        }
        const March next =
            march_advance(march, kronrod_s + kronrod_p, gauss, REAL(0.25), DHR_TOLERANCE, NEGLIGIBLE_DHR);
        if (next.position > march.position) {
          total_s += kronrod_s * march.step;
          total_p += kronrod_p * march.step;
        }
        march = next;
      }
      error += march.error;
      segment.begin += segment.length;
    }
  }
  Dhr result;
  result.s = total_s;
  result.p = total_p;
  result.error = total_s + total_p > REAL(0.0) ? error / (total_s + total_p) + RING_TOLERANCE : REAL(0.0);
  return result;
}

// The whole model, Eqs. (14), (16)-(18): factors of one polar angle, factors of
// one azimuth, and their product. Tables and single directions compose the same functions.
#pragma once
#include "angles.h"
#include "dialect.h"
#include "elementary.h"
#include "fresnel.h"
#include "lobes.h"
#include "material.h"
#include "shadowing.h"

typedef struct {
  real theta;  // degrees
  real sine;
  real cosine;
  real v;
  Fresnel fresnel;
} PolarFactors;

FN PolarFactors polar_factors(real theta, MaterialConstants m, ModelVariant variant) {
  const SineCosine direction = sincos_degrees(theta);
  PolarFactors f;
  f.theta = theta;
  f.sine = direction.sine;
  f.cosine = direction.cosine;
  f.v = width_shadowing(direction.sine, m, variant).value;
  f.fresnel = fresnel(direction.sine, direction.cosine, m);
  return f;
}

typedef struct {
  real cos_phi;
  real sin2_phi;
  real sin2_half;  // sin^2(phi/2)
  real cos2_half;
  real forward;  // 1 where alpha >= 0, else 0
} AzimuthFactors;

FN AzimuthFactors azimuth_factors(real phi) {
  const SineCosine half_angle = sincos_degrees(REAL(0.5) * phi);
  AzimuthFactors f;
  f.sin2_half = half_angle.sine * half_angle.sine;
  f.cos2_half = half_angle.cosine * half_angle.cosine;
  f.cos_phi = (half_angle.cosine - half_angle.sine) * (half_angle.cosine + half_angle.sine);
  f.sin2_phi = REAL(4.0) * f.sin2_half * f.cos2_half;
  f.forward = f.cos_phi >= REAL(0.0) ? REAL(1.0) : REAL(0.0);
  return f;
}

// Amplitudes of the lobes, Eqs. (15), (17), (18), with g = sqrt(R R') and
// 1 - g = (T + R T')/(1 + g), whose terms are all positive.
typedef struct {
  real surface;
  real subsurface;  // 1 - g
} Reflectances;

FN Reflectances reflectances(real modulus_i, real transmittance_i, real modulus_s, real transmittance_s) {
  const real g = modulus_i * modulus_s;
  Reflectances r;
  r.surface = g;
  r.subsurface = fma(modulus_i * modulus_i, transmittance_s, transmittance_i) / (REAL(1.0) + g);
  return r;
}

typedef struct {
  Reflectances s;
  Reflectances p;
} PolarizedReflectances;

FN PolarizedReflectances polarized_reflectances(Fresnel i, Fresnel s) {
  PolarizedReflectances r;
  r.s = reflectances(i.modulus_s, i.transmittance_s, s.modulus_s, s.transmittance_s);
  r.p = reflectances(i.modulus_p, i.transmittance_p, s.modulus_p, s.transmittance_p);
  return r;
}

FN real lobe_amplitude(int lobe, Reflectances r, MaterialConstants m) {
  return lobe == LOBE_SURFACE ? m.sigma_surface * r.surface
                              : (lobe == LOBE_BULK ? m.sigma_bulk : m.sigma_retro) * r.subsurface;
}

// rho'^2, Eqs. (9), (12).
FN real shadowed_rho2(int lobe, PolarFactors i, PolarFactors s, MaterialConstants m, ModelVariant variant) {
  return lobe_rho2(lobe, m) * foreshortening2(i.cosine, s.cosine, variant) * i.v * s.v;
}

// N that a lobe has between two directions; n_s is read for reciprocal normalisation only.
FN real pair_normalization(real n_i, real n_s, ModelVariant variant) {
  return variant.normalization == NORMALIZATION_RECIPROCAL ? sqrt(n_i) * sqrt(n_s) : n_i;
}

// N times the profile of a lobe: N/D, or N exp(-d^2/(4 rho'^2)).
FN real normalized_profile(int lobe, LobeDistance d, AzimuthFactors azimuth, real rho2, real n,
                           ModelVariant variant) {
  const real d2 = fma(d.transverse, lobe == LOBE_RETRO ? azimuth.cos2_half : azimuth.sin2_half, d.axial);
  if (variant.autocovariance == AUTOCOVARIANCE_LORENTZIAN) return n / (d2 + rho2);
  // No exponent at the peak, where both may have underflowed.
  return d2 > REAL(0.0) ? n * exponential(REAL(-0.25) * d2 / rho2) : n;
}

FN_INLINED int lobe_is_shadowed(int lobe, ModelVariant variant) {
  return variant.reflectance_shadowing == REFLECTANCE_SHADOWING_ALL ||
         (variant.reflectance_shadowing == REFLECTANCE_SHADOWING_SURFACE && lobe == LOBE_SURFACE);
}

typedef struct {
  real s;
  real p;
} Brdf;

// f in 1/sr for both polarisations. n_i, n_s: N of the three lobes at either polar angle.
FN Brdf brdf(PolarFactors i, PolarFactors s, AzimuthFactors azimuth, const real *n_i, const real *n_s,
             MaterialConstants m, ModelVariant variant) {
  const LobeDistance distance = lobe_distance(i.theta, s.theta, i.sine, s.sine);
  const PolarizedReflectances reflectance = polarized_reflectances(i.fresnel, s.fresnel);
  const real v_m = reflectance_shadowing(
      incidence_shadowing(i.sine, i.cosine, m),
      scatter_shadowing(s.sine, s.cosine, azimuth.cos_phi, azimuth.sin2_phi, m), azimuth.cos_phi);
  Brdf f;
  f.s = REAL(0.0);
  f.p = REAL(0.0);
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const real rho2 = shadowed_rho2(lobe, i, s, m, variant);
    const real n = pair_normalization(n_i[lobe], n_s[lobe], variant);
    const real profile = (lobe_is_shadowed(lobe, variant) ? v_m : REAL(1.0)) *
                         normalized_profile(lobe, distance, azimuth, rho2, n, variant);
    // A lobe of no amplitude adds nothing, even where its profile is singular.
    const real amplitude_s = lobe_amplitude(lobe, reflectance.s, m);
    const real amplitude_p = lobe_amplitude(lobe, reflectance.p, m);
    f.s += amplitude_s > REAL(0.0) ? amplitude_s * profile : REAL(0.0);
    f.p += amplitude_p > REAL(0.0) ? amplitude_p * profile : REAL(0.0);
  }
  return f;
}

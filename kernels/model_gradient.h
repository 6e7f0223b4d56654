// ln f and its derivatives by the fourteen parameters, for Lorentzian lobes with hemispherical or reciprocal
// N.
#pragma once
#include "fresnel_gradient.h"
#include "gradient.h"
#include "model.h"
#include "shadowing_gradient.h"

typedef struct {
  real theta;
  SineCosine direction;
  WidthShadowingGradient v;
  Fresnel fresnel;
  FresnelGradient fresnel_slope;
} PolarGradient;

FN PolarGradient polar_gradient(real theta, GradientConstants g, ModelVariant variant) {
  PolarGradient f;
  f.theta = theta;
  f.direction = sincos_degrees(theta);
  f.v = width_shadowing_gradient(f.direction.sine, g, variant);
  f.fresnel = fresnel(f.direction.sine, f.direction.cosine, g.m);
  f.fresnel_slope = fresnel_gradient(f.direction.sine, f.direction.cosine, g.m);
  return f;
}

typedef struct {
  real ln_f;
  real by[PARAMETER_COUNT];  // d ln f / d parameter
} LogBrdfGradient;

// A component of N, or of the derivatives of ln N, between two directions; that at theta_s is read for
// reciprocal normalisation only.
FN real pair_normalization_gradient(int component, real n_i, real n_s, ModelVariant variant) {
  if (component == N_VALUE) return pair_normalization(n_i, n_s, variant);
  return variant.normalization == NORMALIZATION_RECIPROCAL ? REAL(0.5) * (n_i + n_s) : n_i;
}

// n: [LOBE_COUNT][N_COMPONENTS] between the two directions; share_s: the part of s-polarised light, 1/2 where
// it is unpolarised.
FN LogBrdfGradient log_brdf_gradient(PolarGradient i, PolarGradient s, AzimuthFactors azimuth, const real *n,
                                     real share_s, GradientConstants constants, ModelVariant variant) {
  const MaterialConstants m = constants.m;
  const real share_p = REAL(1.0) - share_s;
  const LobeDistance distance = lobe_distance(i.theta, s.theta, i.direction.sine, s.direction.sine);
  const PolarizedReflectances r = polarized_reflectances(i.fresnel, s.fresnel);
  const real g = share_s * r.s.surface + share_p * r.p.surface;
  const real g_by_n_eff = share_s * r.s.surface * (i.fresnel_slope.s.re + s.fresnel_slope.s.re) +
                          share_p * r.p.surface * (i.fresnel_slope.p.re + s.fresnel_slope.p.re);
  const real g_by_k_eff = -(share_s * r.s.surface * (i.fresnel_slope.s.im + s.fresnel_slope.s.im) +
                            share_p * r.p.surface * (i.fresnel_slope.p.im + s.fresnel_slope.p.im));
  const real subsurface = share_s * r.s.subsurface + share_p * r.p.subsurface;
  const ReflectanceShadowingGradient v_m =
      reflectance_shadowing_gradient(i.direction.sine, i.direction.cosine, s.direction.sine,
                                     s.direction.cosine, azimuth.cos_phi, azimuth.sin2_phi, m);
  const real spread =
      foreshortening2(i.direction.cosine, s.direction.cosine, variant) * i.v.value * s.v.value;

  LogBrdfGradient f;
  for (int k = 0; k < PARAMETER_COUNT; ++k) f.by[k] = REAL(0.0);
  real sum = REAL(0.0);
  real shadowed = REAL(0.0);
  real by_g = REAL(0.0);
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const int is_surface = lobe == LOBE_SURFACE;
    const scalar sigma = is_surface ? m.sigma_surface : lobe == LOBE_BULK ? m.sigma_bulk : m.sigma_retro;
    const real rho2 = lobe_rho2(lobe, m) * spread;
    const real d2 =
        fma(distance.transverse, lobe == LOBE_RETRO ? azimuth.cos2_half : azimuth.sin2_half, distance.axial);
    const real inverse_d = REAL(1.0) / (d2 + rho2);
    const real profile = n[lobe * N_COMPONENTS + N_VALUE] * inverse_d;
    const real bare = (is_surface ? g : subsurface) * profile;
    const real passed = lobe_is_shadowed(lobe, variant) ? v_m.value : REAL(1.0);
    const real per_sigma = bare * passed;
    shadowed += lobe_is_shadowed(lobe, variant) ? sigma * bare : REAL(0.0);
    const real amplitude = sigma * per_sigma;
    const real share = rho2 * inverse_d;
    sum += amplitude;
    by_g += (is_surface ? sigma : -sigma) * profile * passed;
    f.by[BY_SIGMA_SURFACE + 2 * lobe] = per_sigma;
    f.by[BY_RHO_SURFACE + 2 * lobe] = amplitude * (n[lobe * N_COMPONENTS + N_BY_LN_RHO] - REAL(2.0) * share) *
                                      WIDE(SCALAR(1.0) / sqrt(lobe_rho2(lobe, m)));
    f.by[BY_W] += amplitude * (n[lobe * N_COMPONENTS + N_BY_LN_W] - share * (i.v.by_ln_w + s.v.by_ln_w)) *
                  WIDE(sqrt(m.inverse_w2));
    f.by[BY_N] +=
        amplitude * (n[lobe * N_COMPONENTS + N_BY_FLATNESS] - share * (i.v.by_flatness + s.v.by_flatness));
  }
  f.by[BY_N_EFF] = by_g * g_by_n_eff;
  f.by[BY_K_EFF] = by_g * g_by_k_eff;
  f.by[BY_W_A] = shadowed * v_m.by_w_a;
  f.by[BY_W_B] = shadowed * v_m.by_w_b;
  f.by[BY_GAMMA] = shadowed * v_m.by_gamma;
  f.by[BY_DELTA] = shadowed * v_m.by_delta;
  const real inverse_sum = REAL(1.0) / sum;
  for (int k = 0; k < PARAMETER_COUNT; ++k) f.by[k] *= inverse_sum;
  f.ln_f = sum > REAL(0.0) ? logarithm(sum) : WIDE(-INFINITY);
  return f;
}

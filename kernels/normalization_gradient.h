// N of a Lorentzian lobe with the derivatives of ln N by ln rho, ln w and n, integrated along the same path
// as normalization(), BRDFTAB_WIDTH nodes at a time.
#pragma once
#include "dialect.h"
#include "peak_path.h"
#include "quadrature.h"
#include "shadowing_gradient.h"

// A fit needs N to a few digits more than a measurement has.
#if BRDFTAB_WORKING_DOUBLE
#define GRADIENT_TOLERANCE SCALAR(1e-11)
#else
#define GRADIENT_TOLERANCE PANEL_TOLERANCE
#endif

typedef struct {
  scalar component[N_COMPONENTS];
} NormalizationGradient;

FN scalar sum_of_lanes(real values) {
  scalar lane[BRDFTAB_WIDTH];
  STORE(values, 0, lane);
  scalar sum = SCALAR(0.0);
  for (int k = 0; k < BRDFTAB_WIDTH; ++k) sum += lane[k];
  return sum;
}

FN scalar first_lane(real values) {
  scalar lane[BRDFTAB_WIDTH];
  STORE(values, 0, lane);
  return lane[0];
}

// 1/N = pi I, I = integral of 1/R du with R^2 = v^2 + p (2 (u + a) + p), v = u - a, p = rho'^2. By a
// parameter y, dI/dy = - integral of (p (u + a + p)/R^2) d ln p/dy / R du; the first factor lies between 0
// and 1, so that the path which takes the peak out of I does so here.
FN_SHARED NormalizationGradient normalization_gradient(SineCosine incidence, int lobe, GradientConstants g,
                                                       ModelVariant variant) {
  const real rho2 = WIDE(lobe_rho2(lobe, g.m));
  const real mu2_i = incidence.cosine * incidence.cosine;
  const real a = incidence.sine * incidence.sine;
  const PeakWidth width = peak_width(incidence.sine, incidence.cosine, rho2, g.m, variant);
  const WidthShadowingGradient v_i = width_shadowing_gradient(incidence.sine, g, variant);
  // What a peak too narrow for numbers adds is ln_missing, const - ln rho^2 - 2 ln V(sin theta_i).
  const scalar missing = first_lane(width.ln_missing);
  const scalar by_missing = missing > SCALAR(0.0) ? SCALAR(2.0) : SCALAR(0.0);
  scalar integral = missing;
  scalar by_ln_rho = by_missing;
  scalar by_ln_w = by_missing * first_lane(v_i.by_ln_w);
  scalar by_flatness = by_missing * first_lane(v_i.by_flatness);
  for (int outer = 0; outer < 2; ++outer) {
    const PeakSegment segment = peak_side(outer, a, mu2_i, width.h);
    if (!(first_lane(segment.length) > SCALAR(0.0))) continue;
    March march = march_begin(first_lane(first_step(segment)));
    while (march_unfinished(march)) {
      real kronrod = REAL(0.0);
      real gauss = REAL(0.0);
      real rho_slope = REAL(0.0);
      real w_slope = REAL(0.0);
      real n_slope = REAL(0.0);
      for (int k = 0; k < (PANEL_NODES + 1) / BRDFTAB_WIDTH; ++k) {
        const PeakPoint point =
            peak_point(fma(WIDE(march.step), LOAD(k, panel_node), WIDE(march.position)), segment);
        const WidthShadowingGradient v_s = width_shadowing_gradient(sqrt(point.u), g, variant);
        const real p_resolved = foreshortening2(incidence.cosine, point.mu_s, variant) *
                                exponential(width.ln_rho2 + v_s.logarithm);
        const real p = p_resolved + width.floor;
        const real r2 = fma(point.v, point.v, p * fma(REAL(2.0), point.u + a, p));
        const real value = point.jacobian / sqrt(r2);
        const real weighted = LOAD(k, kronrod_weight) * value;
        const real slope = weighted * p_resolved * (point.u + a + p) / r2;
        kronrod += weighted;
        gauss = fma(LOAD(k, gauss_weight), value, gauss);
        rho_slope += slope;
        w_slope = fma(slope, v_i.by_ln_w + v_s.by_ln_w, w_slope);
        n_slope = fma(slope, v_i.by_flatness + v_s.by_flatness, n_slope);
      }
      const scalar before = march.integral;
      const scalar step = march.step;
      march = march_advance(march, sum_of_lanes(kronrod), sum_of_lanes(gauss), SCALAR(0.125),
                            GRADIENT_TOLERANCE, SCALAR(0.0));
      if (march.integral > before) {  // the panel was accepted
        by_ln_rho = fma(SCALAR(2.0) * step, sum_of_lanes(rho_slope), by_ln_rho);
        by_ln_w = fma(step, sum_of_lanes(w_slope), by_ln_w);
        by_flatness = fma(step, sum_of_lanes(n_slope), by_flatness);
      }
    }
    integral += march.integral;
  }
  // ln N = -ln I - ln pi.
  NormalizationGradient n;
  n.component[N_VALUE] = SCALAR(1.0) / (SCALAR(3.14159265358979323846) * integral);
  n.component[N_BY_LN_RHO] = by_ln_rho / integral;
  n.component[N_BY_LN_W] = by_ln_w / integral;
  n.component[N_BY_FLATNESS] = by_flatness / integral;
  return n;
}

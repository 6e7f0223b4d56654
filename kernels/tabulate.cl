// Entry points for grids. What depends on polar angles only is computed once for
// each pair of them, in the working precision; a sample is then a multiply-add
// and a division for each lobe, in the table's precision.
#include "model.h"

#if BRDFTAB_TABLE_DOUBLE
typedef double table_real;
#define TABLE_MIN REAL(2.2250738585072014e-308)
#define TABLE_MAX REAL(1.7976931348623157e+308)
#define LOBE_NEGLIGIBLE REAL(1e-307)
#else
typedef float table_real;
#define TABLE_MIN REAL(1.17549435e-38)
#define TABLE_MAX REAL(3.40282347e+38)
#define LOBE_NEGLIGIBLE REAL(1e-37)
#endif

// Alarms of a pair of polar angles, shifted by the lobe: a peak near or beyond the table's range,
// or coefficients that the table's precision cannot hold.
enum { PAIR_NEAR_LIMIT = 1, PAIR_UNREPRESENTABLE = 8 };

// The factors of one of `angles` polar angles, from arrays [POLAR_FACTORS][angles]: neighbouring work-items
// read neighbouring numbers.
FN PolarFactors polar_at(__global const real *restrict factors, int angles, size_t k) {
  PolarFactors polar;
  polar.theta = factors[k];
  polar.sine = factors[k + angles];
  polar.cosine = factors[k + 2 * (size_t)angles];
  polar.v = factors[k + 3 * (size_t)angles];
  polar.fresnel.modulus_s = factors[k + 4 * (size_t)angles];
  polar.fresnel.modulus_p = factors[k + 5 * (size_t)angles];
  polar.fresnel.transmittance_s = factors[k + 6 * (size_t)angles];
  polar.fresnel.transmittance_p = factors[k + 7 * (size_t)angles];
  return polar;
}

// S of Eq. (13), and 1 - S on the forward side, else 0: [2][theta_s][azimuth]. V_m = (1 - E_0) + S E_0 is
// then S + (1 - S)(1 - E_0) on either side. Without shadowing S = 1.
__kernel void scatter_shadowing_table(__global const real *restrict polar_s, int angles_s,
                                      __global const AzimuthFactors *restrict azimuth, int first_s,
                                      int azimuths, __global table_real *restrict shadowing,
                                      MaterialConstants m, ModelVariant variant) {
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const PolarFactors polar = polar_at(polar_s, angles_s, first_s + s);
  const AzimuthFactors phi = azimuth[x];
  const Attenuation a =
      attenuation(scatter_shadowing_exponent(polar.sine, polar.cosine, phi.cos_phi, phi.sin2_phi, m));
  const int none = variant.reflectance_shadowing == REFLECTANCE_SHADOWING_NONE;
  const size_t at = s * azimuths + x;
  shadowing[at] = none ? 1 : (table_real)a.passed;
  shadowing[get_global_size(1) * azimuths + at] = none ? 0 : (table_real)(phi.forward * a.blocked);
}

// The mean with weights 1/2 and 1/2, 1 and 0, or 0 and 1, all exact: a choice by branches would not be
// vectorised.
FN Reflectances polarization_reflectances(PolarFactors i, PolarFactors s, real weight_s, real weight_p) {
  const PolarizedReflectances r = polarized_reflectances(i.fresnel, s.fresnel);
  Reflectances mean;
  mean.surface = fma(weight_s, r.s.surface, weight_p * r.p.surface);
  mean.subsurface = fma(weight_s, r.s.subsurface, weight_p * r.p.subsurface);
  return mean;
}

// A Lorentzian lobe between two polar angles is amplitude/(axial + transverse sin^2(phi/2)), N included. Both
// sides are scaled so that the denominator ranges about 1, and products of all three lobes' stay far from the
// ends of the table's range. [lobe][3][theta_i][theta_s], of pairs_i x pairs_s. n_i: [LOBE_COUNT][count_i];
// n_s: [LOBE_COUNT][count_s], which matters for reciprocal normalisation only.
__kernel void lorentzian_pairs(__global const real *restrict polar_i, __global const real *restrict polar_s,
                               __global const real *restrict n_i, int count_i,
                               __global const real *restrict n_s, int count_s, int first_i, int first_s,
                               int pairs_i, int pairs_s, __global table_real *restrict pairs,
                               __global int *restrict alarms, real weight_s, real weight_p,
                               MaterialConstants m, ModelVariant variant) {
  const size_t s = get_global_id(0);
  const size_t i = get_global_id(1);
  const size_t at = i * pairs_s + s;
  const size_t count = (size_t)pairs_i * pairs_s;
  const PolarFactors factors_i = polar_at(polar_i, count_i, first_i + i);
  const PolarFactors factors_s = polar_at(polar_s, count_s, first_s + s);
  const Reflectances reflectance = polarization_reflectances(factors_i, factors_s, weight_s, weight_p);
  const LobeDistance distance =
      lobe_distance(factors_i.theta, factors_s.theta, factors_i.sine, factors_s.sine);
  int alarm = 0;
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const real n =
        pair_normalization(n_i[lobe * count_i + first_i + i], n_s[lobe * count_s + first_s + s], variant);
    const real amplitude = lobe_amplitude(lobe, reflectance, m) * n;
    const real nearest = distance.axial + shadowed_rho2(lobe, factors_i, factors_s, m, variant);
    const real farthest = nearest + distance.transverse;
    // A lobe that nowhere reaches what the table can hold is none.
    const int present = !(amplitude <= LOBE_NEGLIGIBLE * nearest) & !(amplitude <= REAL(0.0));
    const real middle = REAL(1.0) / (sqrt(fmax(nearest, farthest * REAL(1e-30))) * sqrt(farthest));
    const real scale = fmax(middle, REAL(1e-30) / amplitude);
    const int near_limit = (scale * nearest < TABLE_MIN * REAL(16.0)) |
                           (amplitude > nearest * (TABLE_MAX / REAL(16.0))) |
                           (scale * amplitude > TABLE_MAX * REAL(1e-10));
    const int representable = (scale * farthest < TABLE_MAX) & (scale * amplitude < TABLE_MAX);
    alarm |= ((present & near_limit) ? PAIR_NEAR_LIMIT : 0) << lobe;
    alarm |= ((present & !representable) ? PAIR_UNREPRESENTABLE : 0) << lobe;
    __global table_real *restrict pair = pairs + lobe * 3 * count + at;
    pair[0] = present ? (table_real)(scale * amplitude) : 0;
    pair[count] = present ? (table_real)(scale * nearest) : 1;
    pair[2 * count] = present ? (table_real)(scale * distance.transverse) : 0;
  }
  alarms[at] = alarm;
}

// What of the tables a range of nodes takes. Azimuths are those of one or more rows of phi_s; shadowing:
// [theta_s][azimuth].
typedef struct {
  int first_i;      // of theta_i
  int first_phi_i;  // of the rows
  int count_phi_i;
  int first_s;  // of theta_s in the shadowing's table
  int count_s;  // there
  int nodes_phi_s;
  int azimuths;
} Range;

// Where a node is: work-items run over phi_s, then theta_i and phi_i together, then theta_s, so that
// neighbouring work-groups share the shadowing of a theta_s.
typedef struct {
  size_t i;
  size_t azimuth;
  size_t pair, pairs;            // [theta_i][theta_s], and how many
  size_t shadowing, shadowings;  // [theta_s][azimuth], and how many
  size_t sample;                 // [theta_i][phi_i][theta_s][phi_s]
} Node;

FN Node node_here(Range range, __global const int *restrict row) {
  const size_t incidence = get_global_id(1);
  const size_t i = incidence / (size_t)range.count_phi_i;
  const size_t s = get_global_id(2);
  Node node;
  node.i = range.first_i + i;
  node.azimuth = row[range.first_phi_i + incidence % (size_t)range.count_phi_i] + get_global_id(0);
  node.pair = i * get_global_size(2) + s;
  node.pairs = get_global_size(1) / (size_t)range.count_phi_i * get_global_size(2);
  node.shadowing = (range.first_s + s) * (size_t)range.azimuths + node.azimuth;
  node.shadowings = range.count_s * (size_t)range.azimuths;
  node.sample = (incidence * get_global_size(2) + s) * range.nodes_phi_s + get_global_id(0);
  return node;
}

// f, [theta_i][phi_i][theta_s][phi_s]. Exact global size; no guards. `incidence` holds 1 - E_0 of every
// theta_i; `row`: the first azimuth of each phi_i. Above and below the surface, V_m or, where
// `subsurface_shadowed` is 0, 1. With `combined`, one division serves all lobes; see Plan::combines().
#define LORENTZIAN_SAMPLES(name, combined)                                                              \
  __kernel void name(                                                                                   \
      __global const table_real *restrict pairs, __global const table_real *restrict incidence,         \
      __global const table_real *restrict scatter, __global const table_real *restrict sin2_half,       \
      __global const table_real *restrict cos2_half, __global table_real *restrict f,                   \
      __global const int *restrict row, Range range, table_real subsurface_shadowed) {                  \
    const Node node = node_here(range, row);                                                            \
    const size_t x = node.azimuth;                                                                      \
    __global const table_real *restrict amplitude = pairs + node.pair;                                  \
    __global const table_real *restrict nearest = amplitude + node.pairs;                               \
    __global const table_real *restrict transverse = nearest + node.pairs;                              \
    const size_t lobe = 3 * node.pairs;                                                                 \
    const table_real above =                                                                            \
        fma(scatter[node.shadowing + node.shadowings], incidence[node.i], scatter[node.shadowing]);     \
    const table_real below = fma(above, subsurface_shadowed, 1 - subsurface_shadowed);                  \
    const table_real surface = fma(transverse[0], sin2_half[x], nearest[0]);                            \
    const table_real bulk = fma(transverse[lobe], sin2_half[x], nearest[lobe]);                         \
    const table_real retro = fma(transverse[2 * lobe], cos2_half[x], nearest[2 * lobe]);                \
    if (combined)                                                                                       \
      f[node.sample] = fma(above * amplitude[0], bulk * retro,                                          \
                           below * surface * fma(amplitude[lobe], retro, amplitude[2 * lobe] * bulk)) / \
                       (surface * (bulk * retro));                                                      \
    else                                                                                                \
      f[node.sample] = fma(above, amplitude[0] / surface,                                               \
                           below * (amplitude[lobe] / bulk + amplitude[2 * lobe] / retro));             \
  }

LORENTZIAN_SAMPLES(lorentzian_samples, 1)
LORENTZIAN_SAMPLES(lorentzian_samples_apart, 0)

// A Gaussian lobe is scale exp(-(axial + transverse sin^2(phi/2))): [lobe][3][theta_i][theta_s]. The exponent
// needs the working precision: in float32 its rounding alone would cost 4e-6 at 1e-30 of the peak.
__kernel void gaussian_pairs(__global const real *restrict polar_i, __global const real *restrict polar_s,
                             __global const real *restrict n_i, int count_i,
                             __global const real *restrict n_s, int count_s, int first_i, int first_s,
                             int pairs_i, int pairs_s, __global real *restrict pairs,
                             __global int *restrict alarms, real weight_s, real weight_p, MaterialConstants m,
                             ModelVariant variant) {
  const size_t s = get_global_id(0);
  const size_t i = get_global_id(1);
  const size_t at = i * pairs_s + s;
  const size_t count = (size_t)pairs_i * pairs_s;
  const PolarFactors factors_i = polar_at(polar_i, count_i, first_i + i);
  const PolarFactors factors_s = polar_at(polar_s, count_s, first_s + s);
  const Reflectances reflectance = polarization_reflectances(factors_i, factors_s, weight_s, weight_p);
  const LobeDistance distance =
      lobe_distance(factors_i.theta, factors_s.theta, factors_i.sine, factors_s.sine);
  int alarm = 0;
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const real n =
        pair_normalization(n_i[lobe * count_i + first_i + i], n_s[lobe * count_s + first_s + s], variant);
    const real amplitude = lobe_amplitude(lobe, reflectance, m);
    const real scale = amplitude > REAL(0.0) ? amplitude * n : REAL(0.0);
    const real rho2 = fmax(shadowed_rho2(lobe, factors_i, factors_s, m, variant), REAL_SMALLEST);
    if (!(scale < TABLE_MAX)) alarm |= PAIR_NEAR_LIMIT << lobe;
    // Past 1/REAL_SMALLEST the exponential is zero anywhere off the peak.
    __global real *restrict pair = pairs + lobe * 3 * count + at;
    pair[0] = scale;
    pair[count] = fmin(REAL(0.25) * distance.axial / rho2, REAL(1.0) / REAL_SMALLEST);
    pair[2 * count] = fmin(REAL(0.25) * distance.transverse / rho2, REAL(1.0) / REAL_SMALLEST);
  }
  alarms[at] = alarm;
}

FN real gaussian_lobe(__global const real *restrict lobe, size_t pairs, real distance) {
  return lobe[0] * exponential(-fma(lobe[2 * pairs], distance, lobe[pairs]));
}

__kernel void gaussian_samples(__global const real *restrict pairs,
                               __global const table_real *restrict incidence,
                               __global const table_real *restrict scatter,
                               __global const real *restrict sin2_half,
                               __global const real *restrict cos2_half, __global table_real *restrict f,
                               __global const int *restrict row, Range range,
                               table_real subsurface_shadowed) {
  const Node node = node_here(range, row);
  __global const real *restrict lobe = pairs + node.pair;
  const size_t next = 3 * node.pairs;
  const table_real above =
      fma(scatter[node.shadowing + node.shadowings], incidence[node.i], scatter[node.shadowing]);
  const table_real below = fma(above, subsurface_shadowed, 1 - subsurface_shadowed);
  const real surface = gaussian_lobe(lobe, node.pairs, sin2_half[node.azimuth]);
  const real bulk = gaussian_lobe(lobe + next, node.pairs, sin2_half[node.azimuth]);
  const real retro = gaussian_lobe(lobe + 2 * next, node.pairs, cos2_half[node.azimuth]);
  f[node.sample] = (table_real)fma((real)above, surface, (real)below * (bulk + retro));
}

// f depends on phi_s - phi_i only: on uniform grids the row of a phi_i is a piece of one longer row,
// strips [theta_i][theta_s][strip], from shift[phi_i] on. f: [theta_i][phi_i][theta_s][phi_s].
__kernel void shifted_rows(__global const table_real *restrict strips, __global const int *restrict shift,
                           __global table_real *restrict f, int strip, int nodes_phi_s, int first_phi_i,
                           int count_phi_i) {
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const size_t incidence = get_global_id(2);
  const size_t i = incidence / (size_t)count_phi_i;
  const size_t from = shift[first_phi_i + incidence % (size_t)count_phi_i];
  f[(incidence * get_global_size(1) + s) * nodes_phi_s + x] =
      strips[(i * get_global_size(1) + s) * strip + from + x];
}

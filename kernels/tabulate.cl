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

enum { POLARIZATION_UNPOLARIZED = 0, POLARIZATION_S = 1, POLARIZATION_P = 2 };
// Alarms of a pair of polar angles, shifted by the lobe: a peak near or beyond the table's range,
// or coefficients that the table's precision cannot hold.
enum { PAIR_NEAR_LIMIT = 1, PAIR_UNREPRESENTABLE = 8 };

__kernel void polar_table(__global const real *restrict theta, __global PolarFactors *restrict polar,
                          MaterialConstants m, ModelVariant variant)
{
  const size_t k = get_global_id(0);
  polar[k] = polar_factors(theta[k], m, variant);
}

__kernel void azimuth_table(__global const real *restrict phi, __global AzimuthFactors *restrict azimuth,
                            __global table_real *restrict sin2_half, __global table_real *restrict cos2_half,
                            __global table_real *restrict forward)
{
  const size_t k = get_global_id(0);
  const AzimuthFactors f = azimuth_factors(phi[k]);
  azimuth[k] = f;
  sin2_half[k] = (table_real)f.sin2_half;
  cos2_half[k] = (table_real)f.cos2_half;
  forward[k] = (table_real)f.forward;
}

// S of Eq. (13): [theta_s][azimuth].
__kernel void scatter_shadowing_table(__global const PolarFactors *restrict polar_s,
                                      __global const AzimuthFactors *restrict azimuth,
                                      int first_s, int azimuths, __global table_real *restrict shadowing,
                                      MaterialConstants m)
{
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const PolarFactors polar = polar_s[first_s + s];
  shadowing[s * azimuths + x] =
      (table_real)scatter_shadowing(polar.sine, polar.cosine, azimuth[x].cos_phi, azimuth[x].sin2_phi, m);
}

// E_0 and 1 - E_0 of Eq. (13): [theta_i][2].
__kernel void incidence_shadowing_table(__global const PolarFactors *restrict polar_i,
                                        __global table_real *restrict shadowing, MaterialConstants m)
{
  const size_t i = get_global_id(0);
  const Attenuation a = incidence_shadowing(polar_i[i].sine, polar_i[i].cosine, m);
  shadowing[2 * i] = (table_real)a.passed;
  shadowing[2 * i + 1] = (table_real)a.blocked;
}

FN Reflectances polarization_reflectances(PolarFactors i, PolarFactors s, int polarization)
{
  const PolarizedReflectances r = polarized_reflectances(i.fresnel, s.fresnel);
  return polarization == POLARIZATION_S ? r.s : polarization == POLARIZATION_P ? r.p : unpolarized(r);
}

// *n_s is read for reciprocal normalisation only; otherwise it need not exist.
FN real table_normalization(__global const real *n_i, __global const real *n_s, ModelVariant variant)
{
  return variant.normalization == NORMALIZATION_RECIPROCAL ? pair_normalization(*n_i, *n_s, variant) : *n_i;
}

// A Lorentzian lobe between two polar angles is 1/(axial + transverse sin^2(phi/2)) once its
// amplitude and N are divided into the distance. [theta_i][theta_s][lobe][2].
// n_i: [LOBE_COUNT][count_i]; n_s: [LOBE_COUNT][count_s].
__kernel void lorentzian_pairs(__global const PolarFactors *restrict polar_i,
                               __global const PolarFactors *restrict polar_s, __global const real *restrict n_i,
                               int count_i, __global const real *restrict n_s, int count_s, int first_i, int first_s,
                               __global table_real *restrict pairs, __global int *restrict alarms,
                               int polarization, MaterialConstants m, ModelVariant variant)
{
  const size_t s = get_global_id(0);
  const size_t i = get_global_id(1);
  const size_t at = i * get_global_size(0) + s;
  const PolarFactors factors_i = polar_i[first_i + i];
  const PolarFactors factors_s = polar_s[first_s + s];
  const Reflectances reflectance = polarization_reflectances(factors_i, factors_s, polarization);
  const LobeDistance distance = lobe_distance(factors_i.theta, factors_s.theta, factors_i.sine, factors_s.sine);
  int alarm = 0;
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const real n = table_normalization(n_i + lobe * count_i + first_i + i, n_s + lobe * count_s + first_s + s, variant);
    const real scale = lobe_amplitude(lobe, reflectance, m) * n;
    const real axial = (distance.axial + shadowed_rho2(lobe, factors_i, factors_s, m, variant)) / scale;
    const real transverse = distance.transverse / scale;
    // A lobe that nowhere reaches what the table can hold is none.
    const int absent = !(scale > REAL(0.0)) || axial > REAL(1.0) / LOBE_NEGLIGIBLE;
    if (!absent && (axial < TABLE_MIN * REAL(16.0)))
      alarm |= PAIR_NEAR_LIMIT << lobe;
    if (!absent && !(transverse < TABLE_MAX))
      alarm |= PAIR_UNREPRESENTABLE << lobe;
    pairs[(at * LOBE_COUNT + lobe) * 2] = absent ? (table_real)INFINITY : (table_real)axial;
    pairs[(at * LOBE_COUNT + lobe) * 2 + 1] = absent ? (table_real)0 : (table_real)transverse;
  }
  alarms[at] = alarm;
}

FN table_real shadow(table_real scatter, table_real forward, table_real passed, table_real blocked)
{
  return forward > 0 ? fma(scatter, passed, blocked) : scatter;
}

// f, [theta_i][theta_s][azimuth]. Exact global size; no guards. `incidence` holds every theta_i.
__kernel void lorentzian_samples(__global const table_real *restrict pairs,
                                 __global const table_real *restrict incidence,
                                 __global const table_real *restrict scatter,
                                 __global const table_real *restrict sin2_half,
                                 __global const table_real *restrict cos2_half,
                                 __global const table_real *restrict forward, __global table_real *restrict f,
                                 int azimuths, int first_i, int surface_shadowed, int subsurface_shadowed)
{
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const size_t i = get_global_id(2);
  const size_t row = i * get_global_size(1) + s;
  __global const table_real *restrict pair = pairs + row * (LOBE_COUNT * 2);
  __global const table_real *restrict e_0 = incidence + 2 * (first_i + i);
  const table_real v_m = shadow(scatter[s * azimuths + x], forward[x], e_0[0], e_0[1]);
  const table_real surface = 1 / fma(pair[1], sin2_half[x], pair[0]);
  const table_real bulk = 1 / fma(pair[3], sin2_half[x], pair[2]);
  const table_real retro = 1 / fma(pair[5], cos2_half[x], pair[4]);
  const table_real one = 1;
  f[row * azimuths + x] =
      fma(surface_shadowed ? v_m : one, surface, (subsurface_shadowed ? v_m : one) * (bulk + retro));
}

// A Gaussian lobe is scale exp(-(axial + transverse sin^2(phi/2))): [theta_i][theta_s][lobe][3]. The exponent
// needs the working precision: in float32 its rounding alone would cost 4e-6 at 1e-30 of the peak.
__kernel void gaussian_pairs(__global const PolarFactors *restrict polar_i,
                             __global const PolarFactors *restrict polar_s, __global const real *restrict n_i,
                             int count_i, __global const real *restrict n_s, int count_s, int first_i, int first_s,
                             __global real *restrict pairs, __global int *restrict alarms, int polarization,
                             MaterialConstants m, ModelVariant variant)
{
  const size_t s = get_global_id(0);
  const size_t i = get_global_id(1);
  const size_t at = i * get_global_size(0) + s;
  const PolarFactors factors_i = polar_i[first_i + i];
  const PolarFactors factors_s = polar_s[first_s + s];
  const Reflectances reflectance = polarization_reflectances(factors_i, factors_s, polarization);
  const LobeDistance distance = lobe_distance(factors_i.theta, factors_s.theta, factors_i.sine, factors_s.sine);
  int alarm = 0;
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    const real n = table_normalization(n_i + lobe * count_i + first_i + i, n_s + lobe * count_s + first_s + s, variant);
    const real amplitude = lobe_amplitude(lobe, reflectance, m);
    const real scale = amplitude > REAL(0.0) ? amplitude * n : REAL(0.0);
    const real rho2 = fmax(shadowed_rho2(lobe, factors_i, factors_s, m, variant), REAL_SMALLEST);
    if (!(scale < TABLE_MAX))
      alarm |= PAIR_NEAR_LIMIT << lobe;
    // Past 1/REAL_SMALLEST the exponential is zero anywhere off the peak.
    pairs[(at * LOBE_COUNT + lobe) * 3] = scale;
    pairs[(at * LOBE_COUNT + lobe) * 3 + 1] = fmin(REAL(0.25) * distance.axial / rho2, REAL(1.0) / REAL_SMALLEST);
    pairs[(at * LOBE_COUNT + lobe) * 3 + 2] = fmin(REAL(0.25) * distance.transverse / rho2, REAL(1.0) / REAL_SMALLEST);
  }
  alarms[at] = alarm;
}

FN real gaussian_lobe(__global const real *restrict lobe, real distance)
{
  return lobe[0] * exp(-fma(lobe[2], distance, lobe[1]));
}

__kernel void gaussian_samples(__global const real *restrict pairs, __global const table_real *restrict incidence,
                               __global const table_real *restrict scatter,
                               __global const AzimuthFactors *restrict azimuth, __global table_real *restrict f,
                               int azimuths, int first_i, int surface_shadowed, int subsurface_shadowed)
{
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const size_t i = get_global_id(2);
  const size_t row = i * get_global_size(1) + s;
  __global const real *restrict pair = pairs + row * (LOBE_COUNT * 3);
  __global const table_real *restrict e_0 = incidence + 2 * (first_i + i);
  const real v_m = (real)shadow(scatter[s * azimuths + x], (table_real)azimuth[x].forward, e_0[0], e_0[1]);
  const real surface = gaussian_lobe(pair, azimuth[x].sin2_half);
  const real bulk = gaussian_lobe(pair + 3, azimuth[x].sin2_half);
  const real retro = gaussian_lobe(pair + 6, azimuth[x].cos2_half);
  f[row * azimuths + x] = (table_real)fma(surface_shadowed ? v_m : REAL(1.0), surface,
                                          (subsurface_shadowed ? v_m : REAL(1.0)) * (bulk + retro));
}

// f depends on phi_s - phi_i only: samples [theta_i][theta_s][azimuth] spread over
// [theta_i][phi_i][theta_s][phi_s], azimuth_of: [phi_i][phi_s], read from first_phi_i on.
__kernel void spread_azimuths(__global const table_real *restrict samples, __global const int *restrict azimuth_of,
                              __global table_real *restrict f, int azimuths, int nodes_phi_s, int first_phi_i,
                              int count_phi_i)
{
  const size_t x = get_global_id(0);
  const size_t s = get_global_id(1);
  const size_t i = get_global_id(2) / (size_t)count_phi_i;
  const size_t phi_i = first_phi_i + get_global_id(2) % (size_t)count_phi_i;
  f[(get_global_id(2) * get_global_size(1) + s) * nodes_phi_s + x] =
      samples[(i * get_global_size(1) + s) * azimuths + azimuth_of[phi_i * nodes_phi_s + x]];
}

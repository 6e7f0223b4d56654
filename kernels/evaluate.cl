// Entry points for lists of directions: N and DHR of a list of polar angles, and f
// of a list of direction pairs.
#include "dhr.h"
#include "model.h"
#include "normalization.h"

// theta in degrees; value and error: [LOBE_COUNT][angles]. Global size: angles x LOBE_COUNT.
__kernel void normalizations(__global const real *restrict theta, int angles, __global real *restrict value,
                             __global real *restrict error, MaterialConstants m, ModelVariant variant)
{
  const size_t angle = get_global_id(0);
  const int lobe = (int)get_global_id(1);
  const size_t at = lobe * (size_t)angles + angle;
  const Normalization n = normalization(sincos_degrees(theta[angle]), lobe, m, variant);
  value[at] = n.value;
  error[at] = n.error;
}

// DHR by lobe and angle; n as `normalizations` gives it. Global size: angles x LOBE_COUNT.
__kernel void dhrs(__global const real *restrict theta, int angles, __global const real *restrict n, __global real *restrict dhr_s,
                   __global real *restrict dhr_p, __global real *restrict error, MaterialConstants m,
                   ModelVariant variant)
{
  const size_t angle = get_global_id(0);
  const int lobe = (int)get_global_id(1);
  const size_t at = lobe * (size_t)angles + angle;
  const Dhr reflectance = dhr(polar_factors(theta[angle], m, variant), lobe, n[at], m, variant);
  dhr_s[at] = reflectance.s;
  dhr_p[at] = reflectance.p;
  error[at] = reflectance.error;
}

// Angles in degrees; n: [LOBE_COUNT][angles], read at incidence[k] and scatter[k]. f in 1/sr.
__kernel void evaluate(__global const real *restrict theta_i, __global const real *restrict theta_s,
                       __global const real *restrict phi, __global const int *restrict incidence,
                       __global const int *restrict scatter, __global const real *restrict n, int angles,
                       __global real *restrict f_s, __global real *restrict f_p, MaterialConstants m,
                       ModelVariant variant)
{
  const size_t k = get_global_id(0);
  real n_i[LOBE_COUNT];
  real n_s[LOBE_COUNT];
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    n_i[lobe] = n[lobe * angles + incidence[k]];
    n_s[lobe] = n[lobe * angles + scatter[k]];
  }
  const Brdf f = brdf(polar_factors(theta_i[k], m, variant), polar_factors(theta_s[k], m, variant),
                      azimuth_factors(phi[k]), n_i, n_s, m, variant);
  f_s[k] = f.s;
  f_p[k] = f.p;
}

// Sizes of the structs that the host shares or allocates, as this device lays them out.
__kernel void layout(__global int *restrict bytes)
{
  bytes[0] = (int)sizeof(MaterialConstants);
  bytes[1] = (int)sizeof(ModelVariant);
  bytes[2] = (int)sizeof(PolarFactors);
  bytes[3] = (int)sizeof(AzimuthFactors);
}

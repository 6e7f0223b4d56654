// Entry points for lists of polar angles: N and DHR.
#include "dhr.h"
#include "model.h"
#include "normalization.h"

// theta in degrees; value and error: [LOBE_COUNT][angles]. Global size: angles x LOBE_COUNT.
__kernel void normalizations(__global const real *restrict theta, int angles, __global real *restrict value,
                             __global real *restrict error, MaterialConstants m, ModelVariant variant) {
  const size_t angle = get_global_id(0);
  const int lobe = (int)get_global_id(1);
  const size_t at = lobe * (size_t)angles + angle;
  const Normalization n = normalization(sincos_degrees(theta[angle]), lobe, m, variant);
  value[at] = n.value;
  error[at] = n.error;
}

// DHR by lobe and angle; n as `normalizations` gives it. Global size: angles x LOBE_COUNT.
__kernel void dhrs(__global const real *restrict theta, int angles, __global const real *restrict n,
                   __global real *restrict dhr_s, __global real *restrict dhr_p,
                   __global real *restrict error, MaterialConstants m, ModelVariant variant) {
  const size_t angle = get_global_id(0);
  const int lobe = (int)get_global_id(1);
  const size_t at = lobe * (size_t)angles + angle;
  const Dhr reflectance = dhr(polar_factors(theta[angle], m, variant), lobe, n[at], m, variant);
  dhr_s[at] = reflectance.s;
  dhr_p[at] = reflectance.p;
  error[at] = reflectance.error;
}

// Sizes of the structs that the host shares or allocates, as this device lays them out.
__kernel void layout(__global int *restrict bytes) {
  bytes[0] = (int)sizeof(MaterialConstants);
  bytes[1] = (int)sizeof(ModelVariant);
  bytes[2] = (int)sizeof(PolarFactors);
  bytes[3] = (int)sizeof(AzimuthFactors);
}

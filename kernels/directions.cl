// Entry point for lists of pairs of directions: each work-item evaluates BRDFTAB_WIDTH of them.
#include "model.h"

FN real gathered(__global const scalar *restrict values, __global const int *restrict index) {
  scalar lane[BRDFTAB_WIDTH];
  for (int k = 0; k < BRDFTAB_WIDTH; ++k) lane[k] = values[index[k]];
  return LOAD(0, lane);
}

// f in 1/sr of each pair. Angles in degrees; N by lobe and angle, [LOBE_COUNT][angles], read at incidence[k]
// and scatter[k]. Global size: pairs / BRDFTAB_WIDTH.
__kernel void evaluate(__global const scalar *restrict theta_i, __global const scalar *restrict theta_s,
                       __global const scalar *restrict phi, __global const int *restrict incidence,
                       __global const int *restrict scatter, __global const scalar *restrict n, int angles,
                       __global scalar *restrict f_s, __global scalar *restrict f_p, MaterialConstants m,
                       ModelVariant variant) {
  const size_t k = get_global_id(0);
  real n_i[LOBE_COUNT];
  real n_s[LOBE_COUNT];
  for (int lobe = 0; lobe < LOBE_COUNT; ++lobe) {
    n_i[lobe] = gathered(n + lobe * angles, incidence + k * BRDFTAB_WIDTH);
    n_s[lobe] = gathered(n + lobe * angles, scatter + k * BRDFTAB_WIDTH);
  }
  const Brdf f =
      brdf(polar_factors(LOAD(k, theta_i), m, variant), polar_factors(LOAD(k, theta_s), m, variant),
           azimuth_factors(LOAD(k, phi)), n_i, n_s, m, variant);
  STORE(f.s, k, f_s);
  STORE(f.p, k, f_p);
}

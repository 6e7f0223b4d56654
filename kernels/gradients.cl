// Entry points for fits: many materials at the same directions. Each work-item of `log_brdf_gradients`
// evaluates BRDFTAB_WIDTH directions.
#include "model_gradient.h"
#include "normalization_gradient.h"

// theta in degrees; n: [material][LOBE_COUNT][N_COMPONENTS][angles]. Global size: angles x LOBE_COUNT x
// materials.
__kernel void normalization_gradients(__global const scalar *restrict theta, int angles,
                                      __global const GradientConstants *restrict materials,
                                      __global scalar *restrict n, ModelVariant variant) {
  const size_t angle = get_global_id(0);
  const int lobe = (int)get_global_id(1);
  const size_t material = get_global_id(2);
  const NormalizationGradient gradient =
      normalization_gradient(sincos_degrees(WIDE(theta[angle])), lobe, materials[material], variant);
  for (int k = 0; k < N_COMPONENTS; ++k)
    n[((material * LOBE_COUNT + lobe) * N_COMPONENTS + k) * angles + angle] = gradient.component[k];
}

// N at angles from N at fewer nodes, as NormalizationNodes has it: first, count: [angle]; share:
// [angle][width]. Global size: angles x 1 x materials.
__kernel void interpolate_normalizations(__global const scalar *restrict at_nodes, int nodes,
                                         __global const int *restrict first,
                                         __global const int *restrict count,
                                         __global const scalar *restrict share, int width,
                                         __global scalar *restrict n) {
  const size_t angle = get_global_id(0);
  const size_t angles = get_global_size(0);
  const size_t material = get_global_id(2);
  for (int c = 0; c < LOBE_COUNT * N_COMPONENTS; ++c) {
    const size_t row = material * LOBE_COUNT * N_COMPONENTS + c;
    scalar sum = SCALAR(0.0);
    for (int j = 0; j < count[angle]; ++j)
      sum = fma(share[angle * width + j], at_nodes[row * nodes + first[angle] + j], sum);
    n[row * angles + angle] = sum;
  }
}

// ln f and d ln f/d parameter of each pair: out[material][1 + PARAMETER_COUNT][pairs]. Angles in degrees;
// incidence, scatter: the indices of theta_i and theta_s among the angles of n; share_s: of each pair, see
// model_gradient.h. Global size: pairs / BRDFTAB_WIDTH x materials.
__kernel void log_brdf_gradients(__global const scalar *restrict theta_i,
                                 __global const scalar *restrict theta_s, __global const scalar *restrict phi,
                                 __global const int *restrict incidence, __global const int *restrict scatter,
                                 __global const scalar *restrict n, int angles,
                                 __global const scalar *restrict share_s,
                                 __global const GradientConstants *restrict materials,
                                 __global scalar *restrict out, ModelVariant variant) {
  const size_t k = get_global_id(0);
  const size_t vectors = get_global_size(0);
  const size_t material = get_global_id(1);
  const GradientConstants g = materials[material];
  real pair_n[LOBE_COUNT * N_COMPONENTS];
  for (int c = 0; c < LOBE_COUNT * N_COMPONENTS; ++c) {
    __global const scalar *by_angle = n + (material * LOBE_COUNT * N_COMPONENTS + c) * angles;
    scalar lane_i[BRDFTAB_WIDTH];
    scalar lane_s[BRDFTAB_WIDTH];
    for (int l = 0; l < BRDFTAB_WIDTH; ++l) {
      lane_i[l] = by_angle[incidence[k * BRDFTAB_WIDTH + l]];
      lane_s[l] = by_angle[scatter[k * BRDFTAB_WIDTH + l]];
    }
    pair_n[c] = pair_normalization_gradient(c % N_COMPONENTS, LOAD(0, lane_i), LOAD(0, lane_s), variant);
  }
  const LogBrdfGradient f = log_brdf_gradient(
      polar_gradient(LOAD(k, theta_i), g, variant), polar_gradient(LOAD(k, theta_s), g, variant),
      azimuth_factors(LOAD(k, phi)), pair_n, LOAD(k, share_s), g, variant);
  const size_t first = material * (1 + PARAMETER_COUNT) * vectors + k;
  STORE(f.ln_f, first, out);
  for (int c = 0; c < PARAMETER_COUNT; ++c) STORE(f.by[c], first + (1 + c) * vectors, out);
}

// What a kernel that differentiates the model is told about a material. Shared with the host like
// material_constants.h.

typedef struct {
  MaterialConstants m;
  scalar scale_slope;  // d ln_gamma_scale / d shape = ln a - digamma(1 + a)
} GradientConstants;

// The order of a gradient's components, that of the host's parameter_table.
enum {
  BY_N_EFF = 0,
  BY_K_EFF = 1,
  BY_SIGMA_SURFACE = 2,
  BY_RHO_SURFACE = 3,
  BY_SIGMA_BULK = 4,
  BY_RHO_BULK = 5,
  BY_SIGMA_RETRO = 6,
  BY_RHO_RETRO = 7,
  BY_W_A = 8,
  BY_W_B = 9,
  BY_GAMMA = 10,
  BY_DELTA = 11,
  BY_W = 12,
  BY_N = 13,
  PARAMETER_COUNT = 14
};

// N of a lobe: its value, and the derivatives of ln N by ln rho, ln w and n.
enum { N_VALUE = 0, N_BY_LN_RHO = 1, N_BY_LN_W = 2, N_BY_FLATNESS = 3, N_COMPONENTS = 4 };

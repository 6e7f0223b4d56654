// What a kernel is told about a material: the paper's parameters with the
// constants that follow from them, and the variant of the model.
// Shared with the host, which includes it once for each precision; hence no
// guard, and every member of a struct has one width.

enum { NORMALIZATION_HEMISPHERICAL = 0, NORMALIZATION_RECIPROCAL = 1, NORMALIZATION_CLOSED_FORM = 2 };
enum { AUTOCOVARIANCE_LORENTZIAN = 0, AUTOCOVARIANCE_GAUSSIAN = 1 };
enum { REFLECTANCE_SHADOWING_ALL = 0, REFLECTANCE_SHADOWING_SURFACE = 1, REFLECTANCE_SHADOWING_NONE = 2 };
enum { LOBE_SURFACE = 0, LOBE_BULK = 1, LOBE_RETRO = 2, LOBE_COUNT = 3 };

typedef struct {
  real n_eff;
  real k_eff;
  real m2_re;           // Re (n_eff + i k_eff)^2
  real m2_im;           // Im (n_eff + i k_eff)^2
  real contrast;        // |1 - (n_eff + i k_eff)^2|
  real sigma_surface;
  real sigma_bulk;
  real sigma_retro;
  real rho2_surface;    // rho^2
  real rho2_bulk;
  real rho2_retro;
  real w_a;
  real w_b;
  real gamma;
  real delta;
  real inverse_w2;      // 1 / w^2
  real shape;           // a = 1 + n
  real ln_gamma_scale;  // ln(a^a e^-a / Gamma(1 + a))
} MaterialConstants;

typedef struct {
  int normalization;
  int autocovariance;
  int foreshortening;
  int width_shadowing;
  int reflectance_shadowing;
} ModelVariant;

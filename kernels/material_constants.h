// What a kernel is told about a material: the paper's parameters with the
// constants that follow from them, and the variant of the model.
// Shared with the host, which includes it once for each precision; hence no
// guard, and every member of a struct has one width.

enum { NORMALIZATION_HEMISPHERICAL = 0, NORMALIZATION_RECIPROCAL = 1, NORMALIZATION_CLOSED_FORM = 2 };
enum { AUTOCOVARIANCE_LORENTZIAN = 0, AUTOCOVARIANCE_GAUSSIAN = 1 };
enum { REFLECTANCE_SHADOWING_ALL = 0, REFLECTANCE_SHADOWING_SURFACE = 1, REFLECTANCE_SHADOWING_NONE = 2 };
enum { LOBE_SURFACE = 0, LOBE_BULK = 1, LOBE_RETRO = 2, LOBE_COUNT = 3 };

typedef struct {
  scalar n_eff;
  scalar k_eff;
  scalar m2_re;     // Re (n_eff + i k_eff)^2
  scalar m2_im;     // Im (n_eff + i k_eff)^2
  scalar contrast;  // |1 - (n_eff + i k_eff)^2|
  scalar sigma_surface;
  scalar sigma_bulk;
  scalar sigma_retro;
  scalar rho2_surface;  // rho^2
  scalar rho2_bulk;
  scalar rho2_retro;
  scalar w_a;
  scalar w_b;
  scalar gamma;
  scalar delta;
  scalar inverse_w2;      // 1 / w^2
  scalar shape;           // a = 1 + n
  scalar ln_gamma_scale;  // ln(a^a e^-a / Gamma(1 + a))
  scalar series_terms;    // of the incomplete gamma function, for every angle; 0: not needed
  scalar fraction_terms;
} MaterialConstants;

typedef struct {
  int normalization;
  int autocovariance;
  int foreshortening;
  int width_shadowing;
  int reflectance_shadowing;
} ModelVariant;

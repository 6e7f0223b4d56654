// The fourteen parameters of the model and its named variant: one row each,
// from which reading, checks, help, attributes and documentation derive.
//
// Source: Renhorn and Boreman, Optics Express 16, 12892 (2008), section 3.
#pragma once

#include <array>
#include <string_view>

namespace brdftab {

/// The paper's fitting parameters. Dimensionless; rho and w are direction cosines.
struct Parameters {
  double n_eff;
  double k_eff;
  double sigma_surface;
  double rho_surface;
  double sigma_bulk;
  double rho_bulk;
  double sigma_retro;
  double rho_retro;
  double w_a;
  double w_b;
  double gamma;
  double delta;
  double w;
  double n;
};

struct ParameterRow {
  std::string_view name;
  std::string_view symbol;
  std::string_view unit;
  double minimum;
  double maximum;
  std::string_view meaning;
  double Parameters::*member;
};

inline constexpr std::array<ParameterRow, 14> parameter_table{{
    {"n_eff", "n_eff", "1", 0.05, 20, "effective refractive index, real part, Eq. (15)", &Parameters::n_eff},
    {"k_eff", "k_eff", "1", 0, 20, "effective refractive index, imaginary part, Eq. (15)",
     &Parameters::k_eff},
    {"sigma_surface", "σ_surface", "1", 0, 100,
     "amplitude of surface scatter; multiplies sqrt(R(θ_i) R(θ_s))", &Parameters::sigma_surface},
    {"rho_surface", "ρ_surface", "direction cosine", 1e-4, 100,
     "width of the surface lobe: inverse correlation length, Eq. (12)", &Parameters::rho_surface},
    {"sigma_bulk", "Σ_bulk", "1", 0, 100, "amplitude of bulk scatter, Eq. (17)", &Parameters::sigma_bulk},
    {"rho_bulk", "ρ_bulk", "direction cosine", 1e-4, 100, "width of the bulk lobe, Eq. (12)",
     &Parameters::rho_bulk},
    {"sigma_retro", "Σ_retro", "1", 0, 100, "amplitude of retro-reflection, Eq. (18)",
     &Parameters::sigma_retro},
    {"rho_retro", "ρ_retro", "direction cosine", 1e-4, 100, "width of the retro lobe, Eq. (12)",
     &Parameters::rho_retro},
    {"w_a", "w_a", "1", 0, 100, "strength of masking and shadowing of reflectance, Eq. (13)",
     &Parameters::w_a},
    {"w_b", "w_b", "1", 0, 100, "onset of masking and shadowing of reflectance, Eq. (13)", &Parameters::w_b},
    {"gamma", "γ", "1", 0, 1000,
     "strength of the transition to a specular surface at grazing incidence, Eq. (13)", &Parameters::gamma},
    {"delta", "δ", "1", 0, 1000,
     "onset of the transition to a specular surface at grazing incidence, Eq. (13)", &Parameters::delta},
    {"w", "w", "direction cosine", 0.05, 100, "width of the shadowing function V, Eq. (10)", &Parameters::w},
    {"n", "n", "1", 0, 60, "flatness of the shadowing function V, real, Eq. (10)", &Parameters::n},
}};

/// N of each lobe: per incidence, symmetrised as sqrt(N(θ_i) N(θ_s)), or Eq. (8).
enum class Normalization { hemispherical, reciprocal, closed_form };
/// Shape of a lobe: Eq. (4) or Eq. (2).
enum class Autocovariance { lorentzian, gaussian };
/// Lobes that V_m of Eq. (13) multiplies.
enum class ReflectanceShadowing { all, surface, none };

/// Variants of the model; the defaults are the paper's full model.
struct Variant {
  Normalization normalization = Normalization::hemispherical;
  Autocovariance autocovariance = Autocovariance::lorentzian;
  bool foreshortening = true;
  bool width_shadowing = true;
  ReflectanceShadowing reflectance_shadowing = ReflectanceShadowing::all;
};

enum class Lobe { surface, bulk, retro };
inline constexpr std::array<std::string_view, 3> lobe_names{"surface", "bulk", "retro"};

}  // namespace brdftab

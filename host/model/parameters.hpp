// The fourteen parameters of the model and its named variant: one row each,
// from which reading, checks, help, attributes and documentation derive.
//
// Source: Renhorn and Boreman, Optics Express 16, 12892 (2008), section 3.
#pragma once

#include <array>
#include <string_view>
#include <vector>

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

  /// The variable of a fit's solver is asinh(x/scale), linear below the scale and logarithmic above: there a
  /// parameter that may be 0 begins to matter. Where the scale is 0, the variable is ln x.
  double scale;
  /// A fit draws its starting points between these, logarithmically, and a share of them at the lower end.
  /// Amplitudes are not drawn: f is linear in them, and they follow from the data.
  double start_low, start_high, share_at_low;
  /// Whether it follows from the surface's geometry and so is the same at all wavelengths.
  bool is_geometric;
};

inline constexpr auto parameter_table = std::to_array<ParameterRow>({
    {"n_eff", "n_eff", "1", 0.05, 20, "effective refractive index, real part, Eq. (15)", &Parameters::n_eff,
     0, 0.6, 4, 0, false},
    {"k_eff", "k_eff", "1", 0, 20, "effective refractive index, imaginary part, Eq. (15)", &Parameters::k_eff,
     0.05, 0.01, 4, 0.4, false},
    {"sigma_surface", "σ_surface", "1", 0, 100,
     "amplitude of surface scatter; multiplies sqrt(R(θ_i) R(θ_s))", &Parameters::sigma_surface, 1e-3, 1, 1,
     1, false},
    {"rho_surface", "ρ_surface", "direction cosine", 1e-4, 100,
     "width of the surface lobe: inverse correlation length, Eq. (12)", &Parameters::rho_surface, 0, 0.004,
     1.5, 0, true},
    {"sigma_bulk", "Σ_bulk", "1", 0, 100, "amplitude of bulk scatter, Eq. (17)", &Parameters::sigma_bulk,
     1e-3, 1, 1, 1, false},
    {"rho_bulk", "ρ_bulk", "direction cosine", 1e-4, 100, "width of the bulk lobe, Eq. (12)",
     &Parameters::rho_bulk, 0, 0.15, 10, 0, true},
    {"sigma_retro", "Σ_retro", "1", 0, 100, "amplitude of retro-reflection, Eq. (18)",
     &Parameters::sigma_retro, 1e-3, 1, 1, 1, false},
    {"rho_retro", "ρ_retro", "direction cosine", 1e-4, 100, "width of the retro lobe, Eq. (12)",
     &Parameters::rho_retro, 0, 0.01, 3, 0, true},
    {"w_a", "w_a", "1", 0, 100, "strength of masking and shadowing of reflectance, Eq. (13)",
     &Parameters::w_a, 0.02, 0.03, 1, 0, true},
    {"w_b", "w_b", "1", 0, 100, "onset of masking and shadowing of reflectance, Eq. (13)", &Parameters::w_b,
     0.02, 0.01, 5, 0, true},
    {"gamma", "γ", "1", 0, 1000,
     "strength of the transition to a specular surface at grazing incidence, Eq. (13)", &Parameters::gamma,
     0.1, 0.05, 30, 0.1, true},
    {"delta", "δ", "1", 0, 1000,
     "onset of the transition to a specular surface at grazing incidence, Eq. (13)", &Parameters::delta, 0.02,
     0.01, 5, 0.2, true},
    {"w", "w", "direction cosine", 0.05, 100, "width of the shadowing function V, Eq. (10)", &Parameters::w,
     0, 0.6, 3, 0, true},
    {"n", "n", "1", 0, 60, "flatness of the shadowing function V, real, Eq. (10)", &Parameters::n, 0.5, 0.05,
     40, 0.3, true},
});

/// The names, in the order of the table.
inline std::vector<std::string_view> parameter_names() {
  std::vector<std::string_view> names;
  for (const ParameterRow& row : parameter_table) names.push_back(row.name);
  return names;
}

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

// The Renhorn-Boreman model, evaluated one pair of directions at a time: the
// scalar reference against which tables are validated.
#pragma once

#include <memory>
#include <vector>

#include "host/model/parameters.hpp"
#include "host/reference/azimuth.hpp"
#include "host/reference/fresnel.hpp"
#include "host/reference/normalization.hpp"
#include "host/reference/quadrature.hpp"

namespace brdftab::reference {

/// Parts of f in 1/sr, or of a reflectance.
struct Lobes {
  double surface;
  double bulk;
  double retro;

  double total() const { return surface + bulk + retro; }
};

/// f for s- and p-polarised incident light, in 1/sr; Eqs. (14), (16).
struct Brdf {
  Lobes s;
  Lobes p;

  Lobes unpolarized() const;
};

/// A hemispherical reflectance per lobe; errors are relative.
struct LobeReflectance {
  Estimate surface;
  Estimate bulk;
  Estimate retro;

  Estimate total() const;
};

struct Reflectance {
  LobeReflectance s;
  LobeReflectance p;

  LobeReflectance unpolarized() const;
};

/// Angles in degrees: θ in [0, 90), any φ = φ_s − φ_i, 0 forward. Safe to share
/// between threads; copies share what they have computed.
class Model {
 public:
  /// Throws std::invalid_argument for a closed-form Gaussian, which Eq. (8) is not.
  Model(const Parameters& parameters, const Variant& variant = {});

  /// Infinite where the lobe exceeds a double, at the exact centre of a lobe.
  Brdf brdf(double theta_i, double theta_s, double phi) const;

  /// N(θ_i) as `normalization` of the variant has it for a single direction: the closed
  /// form of Eq. (8) or the integral over the disc. Infinite if above any double.
  Estimate normalization(Lobe lobe, double theta_i) const;

  /// ∬ f cos θ_s dω, the directional-hemispherical reflectance.
  Reflectance dhr(double theta_i) const;
  /// 2 ∫ dhr cos θ_i sin θ_i dθ_i, the bihemispherical reflectance (white-sky albedo).
  Reflectance bhr() const;

 private:
  struct Cache;

  Width width(Lobe lobe) const;
  double amplitude(Lobe lobe) const;
  bool shadowed(Lobe lobe) const;
  LogEstimate log_normalization_at(Lobe lobe, const Direction& in) const;
  LogEstimate cached_log_normalization(Lobe lobe, double theta) const;
  LogEstimate pair_log_normalization(Lobe lobe, double theta_i, double theta_s) const;
  std::complex<Real> index() const { return {parameters_.n_eff, parameters_.k_eff}; }
  ReflectanceShadowingParameters shadowing() const;
  std::vector<Real> kinks() const;
  std::array<Estimate, 2> lobe_dhr(Lobe lobe, const Direction& in) const;
  Reflectance dhr(const Direction& in) const;

  Parameters parameters_;
  Variant variant_;
  std::shared_ptr<Cache> cache_;
};

}  // namespace brdftab::reference

// V, Eq. (10): masking and shadowing of the surface correlation length.
#pragma once

#include "host/reference/direction.hpp"

namespace brdftab::reference {

/// ln V(χ) = ln Q(1 + n, (1 + n) χ²/w²), Eq. (10); a logarithm because V falls to
/// e^-24400 within the valid ranges. chi_squared = sin²θ; w is a direction cosine.
Real log_width_shadowing(Real chi_squared, Real w, Real n);

/// V(χ) itself; 0 where it underflows.
Real width_shadowing(Real chi_squared, Real w, Real n);

/// ln ρ′² of Eq. (12): ρ′² = ¼ ρ² (μ_i + μ_s)² V(sin θ_i) V(sin θ_s), with the two
/// variant of the model.
struct Width {
  Real rho;
  Real w;
  Real n;
  bool foreshortening;
  bool shadowing;

  /// The part of ln ρ′² that depends on one direction: ln V, or 0 if off.
  Real log_shadowing(Real chi_squared) const;
  Real log_square(const Direction& in, const Direction& out) const;
  /// From cosines and the two ln V, for integrands that hold one of them fixed.
  Real log_square(Real mu_i, Real mu_s, Real log_shadowing_i, Real log_shadowing_s) const;
};

}  // namespace brdftab::reference

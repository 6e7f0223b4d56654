// Fresnel reflectance R of Eq. (15) and transmittance T = 1 − R, complex index.
#pragma once

#include <complex>

#include "host/reference/direction.hpp"

namespace brdftab::reference {

/// A value for s- and for p-polarised incident light.
struct Polarized {
  Real s;
  Real p;
};

/// R_s and R_p of Eq. (15) at a direction; index = n_eff + i k_eff.
Polarized reflectance(std::complex<Real> index, const Direction& direction);

/// T = 1 − R without the subtraction: exactly 0 in total reflection.
Polarized transmittance(std::complex<Real> index, const Direction& direction);

/// g = √(R(θ_i) R(θ_s)), the factor of the surface lobe.
Polarized mean_reflectance(std::complex<Real> index, const Direction& in, const Direction& out);

/// 1 − g, the factor of bulk and retro, Eqs. (17), (18), without the subtraction:
/// with R = 1 − T, 1 − g² = T_i + T_s − T_i T_s.
Polarized mean_transmittance(std::complex<Real> index, const Direction& in, const Direction& out);

}  // namespace brdftab::reference

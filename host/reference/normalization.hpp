// N, the normalisation of a bare lobe: Eqs. (6), (8) in closed form, otherwise
// by adaptive quadrature over the disc of direction cosines.
#pragma once

#include "host/model/parameters.hpp"
#include "host/reference/polar_path.hpp"

namespace brdftab::reference {

/// A logarithm and the estimate of its absolute error. N is kept so because for
/// the Gaussian lobe it can exceed any floating-point number.
struct LogEstimate {
  Real log = 0;
  Real error = 0;
};

/// ln N(θ_i) = −ln ∬ lobe dα dβ over α² + β² ≤ 1, for the lobe 1/D of Eq. (12) or
/// exp(−¼ d²/ρ′²) of Eq. (2). Equal for the lobes at +α₀ and −α₀.
LogEstimate log_normalization(Autocovariance autocovariance, const Width& width, const Direction& in);

/// ln N of Eq. (8): constant ρ, Lorentzian.
LogEstimate log_normalization_closed_form(Real rho, const Direction& in);

/// u = sin²θ_s between which V falls from 1, for the paths of integration.
std::vector<Real> shadowing_steps(const Width& width);

/// ln of the integral over the core that a path leaves out, without V_m.
Real log_core_integral(Autocovariance autocovariance, const PolarPath& path);

/// e^-z I₀(z), z ≥ 0.
Real scaled_bessel_i0(Real z);

}  // namespace brdftab::reference

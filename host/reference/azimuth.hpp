// The integral over φ of one lobe times V_m, at fixed θ_i and θ_s.
#pragma once

#include "host/model/parameters.hpp"
#include "host/reference/polar_path.hpp"
#include "host/reference/reflectance_shadowing.hpp"

namespace brdftab::reference {

/// What of a lobe and of V_m an azimuth integral needs.
struct AzimuthLobe {
  Autocovariance autocovariance;
  bool retro;     // centred at −α₀
  bool shadowed;  // times V_m
  ReflectanceShadowingParameters shadowing;
  Real forward_onset;  // −ln E₀ at the incidence
};

/// A value, which may be below any double, and its relative error.
struct Ring {
  Real value;
  Real error;
};

/// ½ ∫₀^{2π} V_m · lobe dφ; lobe as 1/D or exp(−¼ d²/ρ′²).
Ring azimuth_integral(const AzimuthLobe& lobe, const Direction& in, const PolarNode& node);

/// V_m towards the centre of the lobe at θ_s = θ_i.
Real shadowing_at_peak(const AzimuthLobe& lobe, const Direction& in);

}  // namespace brdftab::reference

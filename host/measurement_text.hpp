// Readers of other programs' measurements. Each gives angles in degrees with phi = 0 on the forward side, and f in 1/sr.
#pragma once

#include <istream>
#include <string>

#include "host/measurement.hpp"

namespace brdftab {

/// ALTA text: `#DIM`, `#PARAM_IN SPHERICAL_TL_PL_TV_PV`, `ISOTROPIC_TV_TL_DPHI` or `ISOTROPIC_TL_TV_PROJ_DPHI`, `#PARAM_OUT
/// INV_STERADIAN[_COSINE_FACTOR]` or `RGB_COLOR`; radians, directions away from the surface. Samples at 90 degrees are set
/// aside and counted, here and in ASTM text.
Measurement read_alta_measurement(std::istream& in, const std::string& source);

/// ASTM E1392 text as Cornell writes it: `VARS theta_i,phi_i,theta_s,phi_s,CHANNEL...`; radians, directions away from the
/// surface.
Measurement read_astm_measurement(std::istream& in, const std::string& source);

/// The same with the rows that the format repeats: one for each node of its grid.
Measurement read_astm_rows(std::istream& in, const std::string& source);

/// Zemax OpticStudio tabular BSDF: degrees about the specular direction, azimuth 0 toward the normal; PlaneSymmetrical or
/// asymmetrical with one SampleRotation; BRDF.
Measurement read_zemax_measurement(std::istream& in, const std::string& source);

/// MERL .binary: 90 x 90 x 180 cells of half-difference angles, sampled at their centres where theta_i and theta_s are whole
/// tens and fives of degrees in plane, in three channels R, G and B.
Measurement read_merl_measurement(std::istream& in, const std::string& source);

}  // namespace brdftab

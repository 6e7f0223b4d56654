// Readers of other programs' measurements. Each gives angles in degrees with phi = 0 on the forward side, and
// the file's values, f in 1/sr. Of the options they take `angles`.
#pragma once

#include <istream>
#include <string>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// ALTA text: `#DIM`, `#PARAM_IN SPHERICAL_TL_PL_TV_PV`, `ISOTROPIC_TV_TL_DPHI` or
/// `ISOTROPIC_TL_TV_PROJ_DPHI`, `#PARAM_OUT INV_STERADIAN[_COSINE_FACTOR]` or `RGB_COLOR`; radians,
/// directions away from the surface. Samples at 90 degrees are set aside and counted, here and in ASTM text.
Measurement read_alta_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

/// ASTM E1392 text as Cornell writes it: `VARS theta_i,phi_i,theta_s,phi_s,CHANNEL...`; radians, directions
/// away from the surface; every row, those that repeat a node of a grid too.
Measurement read_astm_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

/// Zemax OpticStudio tabular BSDF: degrees about the specular direction, azimuth 0 toward the normal;
/// PlaneSymmetrical or asymmetrical with one SampleRotation; BRDF.
Measurement read_zemax_measurement(std::istream& in, const std::string& source,
                                   const MeasurementOptions& options = {});

/// MERL .binary: 90 x 90 x 180 cells of half-difference angles in three channels R, G and B, taken between
/// their centres: with `merl_samples` at so many directions over the hemisphere, else in plane. `angles` has
/// no meaning and is refused.
Measurement read_merl_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

}  // namespace brdftab

// Measured BRDFs in ALTA's text and in ASTM E1392 text. Both are lists of pairs of directions away from the
// surface, in radians. The readers give angles in degrees with phi = 0 on the forward side, and the file's
// values, f in 1/sr. Of the options they take `angles`. Samples at 90 degrees are set aside and counted.
#pragma once

#include <istream>
#include <string>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// ALTA text: `#DIM`, `#PARAM_IN SPHERICAL_TL_PL_TV_PV`, `ISOTROPIC_TV_TL_DPHI` or
/// `ISOTROPIC_TL_TV_PROJ_DPHI`, `#PARAM_OUT INV_STERADIAN[_COSINE_FACTOR]` or `RGB_COLOR`. Throws BadInput
/// `SOURCE:LINE: ...`.
Measurement read_alta_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

/// ASTM E1392 text as Cornell writes it: `VARS theta_i,phi_i,theta_s,phi_s,CHANNEL...`. It gives every row,
/// those that repeat a node of a grid too. Throws BadInput `SOURCE:LINE: ...`.
Measurement read_astm_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

}  // namespace brdftab

// Measured BRDFs in Zemax OpticStudio's tabular BSDF.
#pragma once

#include <istream>
#include <string>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// The file's angles are degrees about the specular direction, azimuth 0 toward the normal; the result's are
/// those of a measurement. The file is PlaneSymmetrical, or asymmetrical with one SampleRotation, and holds
/// BRDF. Of the options it takes `angles`. Throws BadInput `SOURCE:LINE: ...`.
Measurement read_zemax_measurement(std::istream& in, const std::string& source,
                                   const MeasurementOptions& options = {});

}  // namespace brdftab

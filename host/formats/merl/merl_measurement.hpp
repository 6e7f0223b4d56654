// Measured BRDFs in MERL's binary files.
#pragma once

#include <istream>
#include <string>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// Takes f of three channels R, G and B between the centres of the file's 90 x 90 x 180 cells of
/// half-difference angles: with `merl_samples` at so many directions over the hemisphere, else in plane.
/// Throws BadInput where the content is no such file, and for `angles`, which have no meaning here.
Measurement read_merl_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options = {});

}  // namespace brdftab

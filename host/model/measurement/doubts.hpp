// A measurement may look as if its file meant something else than f in 1/sr over directions as its layout has
// them. Each function says what makes it look so, in one line that names the setting which mends it; the line
// is empty where nothing looks so. None of them changes a sample.
#pragma once

#include <string>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// The values as the file gives them look like logarithms of f, which are below 0 in whole stretches; noise
/// is below 0 in single samples.
std::string doubt_of_logarithms(const Measurement& measurement);

/// Away from the mirror and the retro-reflected direction f is above what a surface without gain can reflect.
std::string doubt_of_level(const Measurement& measurement);

/// In plane f would be far more reciprocal than it is if it were divided by cos theta_s.
std::string doubt_of_cosine(const Measurement& measurement);

/// The peak at high incidence is on the backward side.
std::string doubt_of_azimuth(const Measurement& measurement);

/// Most incidences have few samples.
std::string doubt_of_geometry(const Measurement& measurement);

/// There are wavelengths in nm that are no light's.
std::string doubt_of_wavelengths(const Measurement& measurement);

}  // namespace brdftab

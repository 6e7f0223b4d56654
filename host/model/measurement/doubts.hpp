// What makes a measurement look as if its file meant something else than f in 1/sr over directions as its
// layout has them. Each is one line that names the option which mends it, or empty where nothing looks so.
// None of them changes a sample.
#pragma once

#include <string>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// Of values as the file gives them: a logarithm of f is below 0 in whole stretches, and noise in single
/// samples.
std::string doubt_of_logarithms(const Measurement& measurement);

/// Of f: away from the mirror and the retro-reflected direction it is above what a surface without gain can
/// reflect.
std::string doubt_of_level(const Measurement& measurement);

/// Of f in plane: divided by cos theta_s it would be far more reciprocal than it is.
std::string doubt_of_cosine(const Measurement& measurement);

/// The peak at high incidence is on the backward side.
std::string doubt_of_azimuth(const Measurement& measurement);

/// Few samples at most incidences.
std::string doubt_of_geometry(const Measurement& measurement);

/// Wavelengths in nm that are no light's.
std::string doubt_of_wavelengths(const Measurement& measurement);

}  // namespace brdftab

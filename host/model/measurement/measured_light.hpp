// The polarisation of the light that a measurement was made in, and the choice among several.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// Gives the share of s-polarised light.
constexpr double share_s(Polarization light) {
  return light == Polarization::s ? 1 : light == Polarization::p ? 0 : 0.5;
}

/// "s-polarised", "p-polarised" or "unpolarised".
std::string_view light_word(double share_s);

/// Gives the light that `polarization` names: unpolarized, s, p, or all, which is s and p together. Throws
/// BadInput.
std::vector<Polarization> light_named(const std::string& name);

/// Keeps the samples of the light asked for. Where unpolarised light is asked for and only s and p are there,
/// f is their mean. `tells_light` is true where the format says which polarisation a value is of; in other
/// formats all samples become of the one that is asked for. Throws BadInput where the measurement has not
/// what is asked.
void choose_light(Measurement& measurement, const std::vector<Polarization>& light, bool tells_light);

}  // namespace brdftab

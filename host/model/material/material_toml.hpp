// Writes a material as the TOML text that Material reads.
#pragma once

#include <string>

#include "host/model/material.hpp"

namespace brdftab {

/// Numbers keep all their digits, so that reading the text gives the same material. What is as it is without
/// being said, a variant's default or an axis of the default grid, is left out. Bands give the parameters in
/// which they differ and those that a fit gave them. Control characters in texts
/// become blanks, and bytes that are not UTF-8 question marks.
std::string material_toml(const MaterialContent& material);

}  // namespace brdftab

// Turns TOML into what a material holds, or into one line that says where and what is wrong.
#pragma once

#include <string>

#include "host/model/material.hpp"

namespace brdftab {

/// Throws BadInput as TomlDocument does.
MaterialContent read_material_content(const std::string& text, const std::string& source);

}  // namespace brdftab

// A small drawing of the angles and of the sides that count as forward and retro.
#pragma once

#include <string>

namespace brdftab {

/// The text of an SVG file.
std::string angles_sketch();

}  // namespace brdftab

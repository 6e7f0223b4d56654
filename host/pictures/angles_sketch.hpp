// The angles and their conventions as a small drawing.
#pragma once

#include <string>

namespace brdftab {

/// SVG.
std::string angles_sketch();

}  // namespace brdftab

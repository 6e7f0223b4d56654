// A matrix of numbers from -1 to 1 is drawn as coloured cells, with names along two sides.
#pragma once

#include <string>
#include <vector>

namespace brdftab::drawing {

/// The text of an SVG file. -1 is blue, 1 is orange. The texts are written as for Svg::text.
std::string matrix_figure(const std::string& title, const std::vector<std::string>& names,
                          const std::vector<std::vector<double>>& values);

}  // namespace brdftab::drawing

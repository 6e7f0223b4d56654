// A matrix of numbers from -1 to 1 as coloured cells with names along both sides.
#pragma once

#include <string>
#include <vector>

namespace brdftab {

/// SVG; `names` as Svg::text takes them. -1 is blue, 1 orange.
std::string matrix_figure(const std::string& title, const std::vector<std::string>& names,
                          const std::vector<std::vector<double>>& values);

}  // namespace brdftab

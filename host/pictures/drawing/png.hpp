// PNG: from pixels, and from a picture in SVG.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host/pictures/drawing/palette.hpp"

namespace brdftab {

/// Pixels, row by row from the top; none where the page shows.
struct Raster {
  std::size_t width, height;
  std::vector<std::optional<Rgb>> pixels;
};

std::vector<std::byte> png(const Raster& raster);

/// Draws an SVG file's text by librsvg and cairo, so many pixels wide, or 2.5 for each unit if 0. Throws
/// Error where it cannot.
std::vector<std::byte> png_of_svg(std::string_view svg, int width);

}  // namespace brdftab

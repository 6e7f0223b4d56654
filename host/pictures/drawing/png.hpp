// PNG files are made from pixels, or drawn from the text of an SVG file.
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include "host/pictures/drawing/palette.hpp"

namespace brdftab::drawing {

/// The pixels lie row by row from the top. The page shows where there is none.
struct Raster {
  std::size_t width, height;
  std::vector<std::optional<Rgb>> pixels;
};

/// The content of a PNG file.
std::vector<std::byte> png(const Raster& raster);

/// Draws the text of an SVG file by librsvg and cairo. `width` is in pixels; 0 makes 2.5 pixels for each user
/// unit. Throws Error where they cannot draw it.
std::vector<std::byte> png_of_svg(std::string_view svg, int width);

}  // namespace brdftab::drawing

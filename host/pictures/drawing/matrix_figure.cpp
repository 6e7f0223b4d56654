#include "host/pictures/drawing/matrix_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/pictures/drawing/svg.hpp"

namespace brdftab::drawing {
namespace {

constexpr double cell = 38;
constexpr double margin = 14;
constexpr double name_size = 13;
constexpr double head = 44;
constexpr double strong = 0.62;  // beyond this value a cell is too dark for black digits

constexpr Ink on_dark{{255, 255, 255}, {255, 255, 255}};
constexpr Ink on_light{{20, 20, 20}, {20, 20, 20}};

}  // namespace

std::string matrix_figure(const std::string& title, const std::vector<std::string>& names,
                          const std::vector<std::vector<double>>& values) {
  double name_width = 0;
  for (const auto& name : names) name_width = std::max(name_width, text_width(name, name_size));
  const double side = cell * static_cast<double>(names.size());
  const double left = margin + name_width + 8, top = head + name_width + 8;
  const double width = std::max(left + side + margin, 2 * margin + text_width(title, 16, true));
  Svg svg(std::ceil(width), std::ceil(top + side + margin));
  svg.text(margin, 26, title, {.anchor = "start", .size = 16, .bold = true});
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double at = cell * static_cast<double>(i);
    svg.text(left - 6, top + at + cell / 2 + 4, names[i], {.anchor = "end", .size = name_size});
    svg.text(left + at + cell / 2 + 4, top - 6, names[i],
             {.anchor = "start", .size = name_size, .turned = -90});
    for (std::size_t j = 0; j < names.size(); ++j) {
      const double value = std::clamp(values[i][j], -1.0, 1.0);
      const Rgb colour = blue_to_orange.at(0.5 + 0.5 * value);
      const double x = left + cell * static_cast<double>(j);
      svg.fill_box({x, top + at, x + cell, top + at + cell}, {colour, colour});
      svg.text(x + cell / 2, top + at + cell / 2 + 4,
               fmt::format("{}{:.2f}", value < 0 ? "−" : "", std::abs(value)),
               {.size = 11, .ink = std::abs(value) > strong ? on_dark : on_light});
    }
  }
  return svg.document(plain_text(title));
}

}  // namespace brdftab::drawing

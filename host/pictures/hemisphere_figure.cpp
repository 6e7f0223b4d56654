#include "host/pictures/hemisphere_figure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"
#include "host/base/statistics.hpp"
#include "host/pictures/drawing/png.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab {
namespace {

constexpr double outermost = 89.9;
constexpr double margin = 14;
constexpr double gap = 22;
constexpr double head = 62;
constexpr double map_title_space = 22;
constexpr double heading_space = 26;
constexpr double foot_size = 11.5;
constexpr double below_map = 44;
constexpr double left_of_maps = 42;
constexpr double bar_width = 14;
constexpr double bar_space = 96;
constexpr std::size_t bar_steps = 256;
// Marks on a map stand on every colour.
constexpr Ink mark{{255, 255, 255}, {255, 255, 255}};
constexpr Ink mark_edge{{0, 0, 0}, {0, 0, 0}};

struct Disc {
  double x, y, radius;

  double alpha(double cosine) const { return x + radius * cosine; }
  double beta(double cosine) const { return y - radius * cosine; }
};

// Open in the middle, where a narrow peak may be.
void cross(Svg& svg, double x, double y) {
  const std::string d =
      fmt::format("M{0:.2f} {1:.2f}h4M{2:.2f} {1:.2f}h4M{3:.2f} {4:.2f}v4M{3:.2f} {5:.2f}v4", x - 7, y, x + 3,
                  x, y - 7, y + 3);
  svg.path(d, mark_edge, 2.6, "", "stroke-linecap=\"round\"");
  svg.path(d, mark, 1.2, "", "stroke-linecap=\"round\"");
}

void small_ring(Svg& svg, double x, double y, double radius) {
  svg.ring(x, y, radius, mark_edge, 2.6);
  svg.ring(x, y, radius, mark, 1.2);
}

}  // namespace

std::optional<DirectionPair> HemispherePixels::direction(double theta_i, std::size_t row,
                                                         std::size_t column) const {
  const double pixel = 2.0 / static_cast<double>(side_);
  const double x = (static_cast<double>(column) + 0.5) * pixel - 1;
  const double y = 1 - (static_cast<double>(row) + 0.5) * pixel;
  const double radius = std::hypot(x, y);
  if (radius > 1 + 2 * pixel) return std::nullopt;
  const double theta_s = radius < 1 ? std::min(std::asin(radius) / radians_per_degree, outermost) : outermost;
  return DirectionPair{theta_i, theta_s, std::atan2(y, x) / radians_per_degree, 0};
}

std::vector<double> HemispherePixels::values(
    double theta_i,
    const std::function<std::vector<double>(std::span<const DirectionPair>)>& function) const {
  std::vector<DirectionPair> pairs;
  std::vector<std::size_t> places;
  for (std::size_t row = 0; row < side_ / 2; ++row)
    for (std::size_t column = 0; column < side_; ++column)
      if (const auto pair = direction(theta_i, row, column)) {
        pairs.push_back(*pair);
        places.push_back(row * side_ + column);
      }
  const auto f = function(pairs);
  std::vector<double> result(side_ * side_, std::nan(""));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t row = places[k] / side_, column = places[k] % side_;
    result[places[k]] = result[(side_ - 1 - row) * side_ + column] = f[k];
  }
  return result;
}

ChartAxis colour_axis(std::string label, std::vector<double> positive) {
  if (positive.empty()) return logarithmic_axis(std::move(label), 0, 0);
  const double low = percentile(positive, 1);
  return logarithmic_axis(std::move(label), low, *std::max_element(positive.begin(), positive.end()));
}

std::string HemisphereFigure::svg() const {
  // A heading begins a row.
  struct Cell {
    std::size_t row, column;
  };
  std::vector<Cell> cells;
  for (const HemisphereMap& map : maps) {
    if (cells.empty())
      cells.push_back({0, 0});
    else if (!map.heading.empty() || cells.back().column + 1 == columns)
      cells.push_back({cells.back().row + 1, 0});
    else
      cells.push_back({cells.back().row, cells.back().column + 1});
  }
  const std::size_t rows = cells.back().row + 1;
  const std::size_t across =
      std::max_element(cells.begin(), cells.end(),
                       [](const Cell& a, const Cell& b) { return a.column < b.column; })
          ->column +
      1;
  const bool headed =
      std::any_of(maps.begin(), maps.end(), [](const auto& map) { return !map.heading.empty(); });
  const double radius = across <= 2 ? 130 : across == 3 ? 115 : 102;
  const double step_x = 2 * radius + gap;
  const double above_map = map_title_space + (headed ? heading_space : 0);
  const double step_y = above_map + 2 * radius + below_map;
  const double maps_right = margin + left_of_maps + static_cast<double>(across) * step_x - gap;
  const double keys_width = margin + left_of_maps + (footnote.empty() ? 240 : 380);
  const double foot_width =
      std::max(keys_width, margin + left_of_maps + 1.1 * text_width(footnote, foot_size));
  const double footnote_space = footnote.empty() ? 0 : 20;
  const double width = std::ceil(std::max({maps_right + bar_space, 2 * margin + text_width(title, 16, true),
                                           2 * margin + text_width(subtitle, 12.5), foot_width}));
  const double height = std::ceil(head + static_cast<double>(rows) * step_y + 30 + footnote_space);
  Svg svg(width, height);
  svg.text(margin, 26, title, {.anchor = "start", .size = 16, .bold = true});
  svg.text(margin, 45, subtitle, {.anchor = "start", .size = 12.5, .ink = inks::faint_text});
  std::string data;
  for (std::size_t k = 0; k < maps.size(); ++k) {
    const HemisphereMap& map = maps[k];
    const Disc disc{margin + left_of_maps + radius + step_x * static_cast<double>(cells[k].column),
                    head + above_map + radius + step_y * static_cast<double>(cells[k].row), radius};
    const std::size_t side = pixels().side();
    Raster raster{side, side, {}};
    for (const double value : map.values)
      raster.pixels.push_back(std::isnan(value) ? std::optional<Rgb>() : colours->at(scale.position(value)));
    svg.text(disc.x, disc.y - radius - 9, map.title, {.size = 13, .bold = true});
    if (!map.heading.empty())
      svg.text(margin, disc.y - radius - 9 - map_title_space, map.heading, {.anchor = "start", .size = 14});
    svg.clip_to_disc(disc.x, disc.y, radius);
    svg.image({disc.x - radius, disc.y - radius, disc.x + radius, disc.y + radius}, png(raster));
    svg.end_group();
    svg.begin_group("opacity=\"0.4\"");
    for (const double theta : {30, 60})
      svg.ring(disc.x, disc.y, radius * std::sin(radians(theta)), mark, 0.8);
    svg.line(disc.x - radius, disc.y, disc.x + radius, disc.y, mark, 0.8);
    svg.end_group();
    svg.ring(disc.x, disc.y, radius, inks::frame);
    cross(svg, disc.alpha(std::sin(radians(map.theta_i))), disc.y);
    small_ring(svg, disc.alpha(-std::sin(radians(map.theta_i))), disc.y, 4);
    if (map.marked) {
      const double r = std::sin(radians(map.marked->theta_s));
      const double x = disc.alpha(r * std::cos(radians(map.marked->phi))),
                   y = disc.beta(r * std::sin(radians(map.marked->phi)));
      small_ring(svg, x, y, 8);
      small_ring(svg, x, y, 11);
    }
    const bool last_row = cells[k].row + 1 == rows || (k + columns >= maps.size() && !headed);
    for (const double tick : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const double x = disc.alpha(tick), y = disc.beta(tick);
      svg.line(x, disc.y + radius + 2, x, disc.y + radius + 6, inks::frame);
      if (tick != -0.5 && tick != 0.5) svg.text(x, disc.y + radius + 19, number_label(tick), {.size = 11.5});
      if (cells[k].column != 0) continue;
      svg.line(disc.x - radius - 6, y, disc.x - radius - 2, y, inks::frame);
      if (tick != -0.5 && tick != 0.5)
        svg.text(disc.x - radius - 9, y + 4, number_label(tick), {.anchor = "end", .size = 11.5});
    }
    if (cells[k].column == 0)
      svg.text(disc.x - radius - 30, disc.y, "sin θ_s sin φ", {.size = 12, .turned = -90});
    if (last_row) svg.text(disc.x, disc.y + radius + 36, "sin θ_s cos φ", {.size = 12});
    data += fmt::format(R"({}{{"theta_i":{:.9g},"x":{:.2f},"y":{:.2f},"radius":{:.2f}}})", k ? "," : "",
                        map.theta_i, disc.x, disc.y, radius);
  }
  // The scale, from the bottom of the first row of maps to its top; higher where there are more rows.
  const double bar_top = head + above_map;
  const double bar_bottom = bar_top + 2 * radius + (rows > 1 ? step_y : 0);
  const Box bar{maps_right + 20, bar_top, maps_right + 20 + bar_width, bar_bottom};
  Raster shades{1, bar_steps, {}};
  for (std::size_t k = 0; k < bar_steps; ++k)
    shades.pixels.push_back(colours->at(1 - (static_cast<double>(k) + 0.5) / static_cast<double>(bar_steps)));
  svg.image(bar, png(shades), "class=\"scale\"");
  svg.rectangle(bar, inks::frame);
  double last_label = HUGE_VAL;
  for (const Tick& tick : ticks(scale)) {
    const double y = bar.bottom - bar.height() * scale.position(tick.value);
    svg.line(bar.right, y, bar.right + (tick.label.empty() ? 3 : 5), y, inks::frame);
    if (tick.label.empty() || last_label - y < 13) continue;
    svg.text(bar.right + 8, y + 4, tick.label, {.anchor = "start", .size = 11.5});
    last_label = y;
  }
  svg.text(bar.right + 56, bar.middle_y(), scale.label, {.size = 12.5, .turned = -90});
  const double foot = height - 12 - footnote_space;
  double x = margin + left_of_maps;
  const auto key = [&](const char* label, auto draw) {
    // On a patch of the scale, so that marks look as they do on the maps.
    svg.disc(x, foot - 4, 8, {colours->at(0.4), colours->at(0.4)});
    draw(x, foot - 4);
    svg.text(x + 13, foot, label, {.anchor = "start", .size = 11.5, .ink = inks::faint_text});
    x += 13 + text_width(label, 11.5) + 18;
  };
  key("mirror direction", [&](double at, double y) { cross(svg, at, y); });
  key("retro-reflection", [&](double at, double y) { small_ring(svg, at, y, 4); });
  if (std::any_of(maps.begin(), maps.end(), [](const auto& map) { return map.marked.has_value(); }))
    key("largest difference",
        [&](double at, double y) { small_ring(svg, at, y, 4), small_ring(svg, at, y, 7); });
  svg.text(margin + left_of_maps - 8, height - 12, footnote,
           {.anchor = "start", .size = foot_size, .ink = inks::faint_text});
  return svg.document(
      plain_text(title),
      fmt::format(
          R"({{"title":{},"scale":{{"label":{},"low":{:.9g},"high":{:.9g},"logarithmic":{}}},"maps":[{}]}})",
          nlohmann::json(plain_text(title)).dump(), nlohmann::json(plain_text(scale.label)).dump(), scale.low,
          scale.high, scale.logarithmic, data));
}

}  // namespace brdftab

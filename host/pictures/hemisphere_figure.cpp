#include "host/pictures/hemisphere_figure.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"
#include "host/base/statistics.hpp"
#include "host/pictures/drawing/picture_data.hpp"
#include "host/pictures/drawing/png.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab {
namespace {

using drawing::Svg;

constexpr double margin = 14;
constexpr double gap = 22;
constexpr double head = 62;
constexpr double map_title_space = 22;
constexpr double heading_space = 26;
constexpr double title_size = 16;
constexpr double subtitle_size = 12.5;
constexpr double number_size = 11.5;
constexpr double foot_size = 11.5;
constexpr double below_map = 44;
constexpr double left_of_maps = 42;
constexpr double bar_width = 14;
constexpr double bar_space = 96;
constexpr std::size_t bar_steps = 256;
// Marks are white with a black edge, so that they are seen on every colour of a map.
constexpr drawing::Ink mark{{255, 255, 255}, {255, 255, 255}};
constexpr drawing::Ink mark_edge{{0, 0, 0}, {0, 0, 0}};

// The disc of a map on the page. It turns direction cosines into user units.
struct Disc {
  double x, y, radius;

  double alpha(double cosine) const { return x + radius * cosine; }
  double beta(double cosine) const { return y - radius * cosine; }
  double top() const { return y - radius; }
  double bottom() const { return y + radius; }
  double left() const { return x - radius; }
  double right() const { return x + radius; }
};

// The cross is open in the middle, where a narrow peak may be.
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

// Where a map stands among the others.
struct Cell {
  std::size_t row, column;
};

std::vector<Cell> cells_of(const HemisphereFigure& figure) {
  std::vector<Cell> cells;
  for (const HemisphereMap& map : figure.maps) {
    if (cells.empty())
      cells.push_back({0, 0});
    else if (!map.heading.empty() || cells.back().column + 1 == figure.columns)
      cells.push_back({cells.back().row + 1, 0});
    else
      cells.push_back({cells.back().row, cells.back().column + 1});
  }
  return cells;
}

class FigureDrawing {
 public:
  explicit FigureDrawing(const HemisphereFigure& figure)
      : figure_(figure),
        cells_(cells_of(figure)),
        rows_(cells_.back().row + 1),
        is_headed_(std::any_of(figure.maps.begin(), figure.maps.end(),
                               [](const HemisphereMap& map) { return !map.heading.empty(); })) {
    const auto by_column = [](const Cell& a, const Cell& b) { return a.column < b.column; };
    const std::size_t across = std::max_element(cells_.begin(), cells_.end(), by_column)->column + 1;
    radius_ = across <= 2 ? 130 : across == 3 ? 115 : 102;
    above_map_ = map_title_space + (is_headed_ ? heading_space : 0);
    step_x_ = 2 * radius_ + gap;
    step_y_ = above_map_ + 2 * radius_ + below_map;
    maps_right_ = margin + left_of_maps + static_cast<double>(across) * step_x_ - gap;
    footnote_space_ = figure.footnote.empty() ? 0 : 20;
    const double keys_width = margin + left_of_maps + (figure.footnote.empty() ? 240 : 380);
    const double foot_width =
        std::max(keys_width, margin + left_of_maps + 1.1 * drawing::text_width(figure.footnote, foot_size));
    width_ = std::ceil(
        std::max({maps_right_ + bar_space, 2 * margin + drawing::text_width(figure.title, title_size, true),
                  2 * margin + drawing::text_width(figure.subtitle, subtitle_size), foot_width}));
    height_ = std::ceil(head + static_cast<double>(rows_) * step_y_ + 30 + footnote_space_);
  }

  std::string svg() const {
    Svg svg(width_, height_);
    svg.text(margin, 26, figure_.title, {.anchor = "start", .size = title_size, .bold = true});
    svg.text(margin, 45, figure_.subtitle,
             {.anchor = "start", .size = subtitle_size, .ink = drawing::inks::faint_text});
    for (std::size_t k = 0; k < figure_.maps.size(); ++k) {
      draw_map(svg, k);
      draw_marks(svg, k);
      draw_axes(svg, k);
    }
    draw_scale(svg);
    draw_foot(svg);
    return svg.document(drawing::plain_text(figure_.title), drawing::json_text(data()));
  }

 private:
  Disc disc(std::size_t k) const {
    return {margin + left_of_maps + radius_ + step_x_ * static_cast<double>(cells_[k].column),
            head + above_map_ + radius_ + step_y_ * static_cast<double>(cells_[k].row), radius_};
  }

  void draw_map(Svg& svg, std::size_t k) const {
    const HemisphereMap& map = figure_.maps[k];
    const Disc at = disc(k);
    const std::size_t side = HemisphereFigure::pixels().side();
    drawing::Raster raster{side, side, {}};
    for (const double value : map.values)
      raster.pixels.push_back(std::isnan(value) ? std::optional<drawing::Rgb>()
                                                : figure_.colours->at(figure_.scale.position(value)));
    svg.text(at.x, at.top() - 9, map.title, {.size = 13, .bold = true});
    if (!map.heading.empty())
      svg.text(margin, at.top() - 9 - map_title_space, map.heading, {.anchor = "start", .size = 14});
    svg.clip_to_disc(at.x, at.y, radius_);
    svg.image({at.left(), at.top(), at.right(), at.bottom()}, png(raster));
    svg.end_group();
  }

  // Circles at theta_s = 30 and 60 degrees, the mirror direction, retro-reflection and what the map marks.
  void draw_marks(Svg& svg, std::size_t k) const {
    const HemisphereMap& map = figure_.maps[k];
    const Disc at = disc(k);
    svg.begin_group("opacity=\"0.4\"");
    for (const double theta : {30, 60}) svg.ring(at.x, at.y, radius_ * std::sin(radians(theta)), mark, 0.8);
    svg.line(at.left(), at.y, at.right(), at.y, mark, 0.8);
    svg.end_group();
    svg.ring(at.x, at.y, radius_, drawing::inks::frame);
    cross(svg, at.alpha(std::sin(radians(map.theta_i))), at.y);
    small_ring(svg, at.alpha(-std::sin(radians(map.theta_i))), at.y, 4);
    if (!map.marked) return;
    const double r = std::sin(radians(map.marked->theta_s));
    const double x = at.alpha(r * std::cos(radians(map.marked->phi)));
    const double y = at.beta(r * std::sin(radians(map.marked->phi)));
    small_ring(svg, x, y, 8);
    small_ring(svg, x, y, 11);
  }

  // All maps have ticks; numbers of the vertical axis stand at the first map of a row only, and the name of
  // the horizontal axis below the last row only.
  void draw_axes(Svg& svg, std::size_t k) const {
    const Disc at = disc(k);
    const bool is_first = cells_[k].column == 0;
    const bool is_lowest =
        cells_[k].row + 1 == rows_ || (k + figure_.columns >= cells_.size() && !is_headed_);
    for (const double tick : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
      const bool has_number = tick != -0.5 && tick != 0.5;
      const double x = at.alpha(tick), y = at.beta(tick);
      svg.line(x, at.bottom() + 2, x, at.bottom() + 6, drawing::inks::frame);
      if (has_number) svg.text(x, at.bottom() + 19, drawing::number_label(tick), {.size = number_size});
      if (!is_first) continue;
      svg.line(at.left() - 6, y, at.left() - 2, y, drawing::inks::frame);
      if (has_number)
        svg.text(at.left() - 9, y + 4, drawing::number_label(tick), {.anchor = "end", .size = number_size});
    }
    if (is_first) svg.text(at.left() - 30, at.y, "sin θ_s sin φ", {.size = 12, .turned = -90});
    if (is_lowest) svg.text(at.x, at.bottom() + 36, "sin θ_s cos φ", {.size = 12});
  }

  // The scale is as high as the first row of maps, and reaches into the second where there is one.
  void draw_scale(Svg& svg) const {
    const double top = head + above_map_;
    const double bottom = top + 2 * radius_ + (rows_ > 1 ? step_y_ : 0);
    const drawing::Box bar{maps_right_ + 20, top, maps_right_ + 20 + bar_width, bottom};
    drawing::Raster shades{1, bar_steps, {}};
    for (std::size_t k = 0; k < bar_steps; ++k)
      shades.pixels.push_back(
          figure_.colours->at(1 - (static_cast<double>(k) + 0.5) / static_cast<double>(bar_steps)));
    svg.image(bar, png(shades), "class=\"scale\"");
    svg.rectangle(bar, drawing::inks::frame);
    double last_label = HUGE_VAL;
    for (const drawing::Tick& tick : ticks(figure_.scale)) {
      const double y = bar.bottom - bar.height() * figure_.scale.position(tick.value);
      svg.line(bar.right, y, bar.right + (tick.label.empty() ? 3 : 5), y, drawing::inks::frame);
      if (tick.label.empty() || last_label - y < 13) continue;
      svg.text(bar.right + 8, y + 4, tick.label, {.anchor = "start", .size = number_size});
      last_label = y;
    }
    svg.text(bar.right + 56, bar.middle_y(), figure_.scale.label, {.size = 12.5, .turned = -90});
  }

  // What the marks mean, and the footnote.
  void draw_foot(Svg& svg) const {
    const double y = height_ - 12 - footnote_space_;
    double x = margin + left_of_maps;
    const auto key = [&](const char* label, std::initializer_list<double> rings) {
      // A patch in a colour of the scale shows the mark as it looks on the maps.
      svg.disc(x, y - 4, 8, {figure_.colours->at(0.4), figure_.colours->at(0.4)});
      if (rings.size() == 0) cross(svg, x, y - 4);
      for (const double radius : rings) small_ring(svg, x, y - 4, radius);
      svg.text(x + 13, y, label, {.anchor = "start", .size = foot_size, .ink = drawing::inks::faint_text});
      x += 13 + drawing::text_width(label, foot_size) + 18;
    };
    key("mirror direction", {});
    key("retro-reflection", {4});
    if (std::any_of(figure_.maps.begin(), figure_.maps.end(),
                    [](const HemisphereMap& map) { return map.marked.has_value(); }))
      key("largest difference", {4, 7});
    svg.text(margin + left_of_maps - 8, height_ - 12, figure_.footnote,
             {.anchor = "start", .size = foot_size, .ink = drawing::inks::faint_text});
  }

  nlohmann::ordered_json data() const {
    auto maps = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < figure_.maps.size(); ++k) {
      const Disc at = disc(k);
      maps.push_back({{"theta_i", drawing::nine_digits(figure_.maps[k].theta_i)},
                      {"x", drawing::hundredths(at.x)},
                      {"y", drawing::hundredths(at.y)},
                      {"radius", drawing::hundredths(at.radius)}});
    }
    return {{"title", drawing::text_data(figure_.title)},
            {"scale", axis_data(figure_.scale)},
            {"maps", std::move(maps)}};
  }

  const HemisphereFigure& figure_;
  const std::vector<Cell> cells_;
  const std::size_t rows_;
  const bool is_headed_;
  double radius_;
  double above_map_;
  double step_x_, step_y_;  // from one map to the next
  double maps_right_;
  double footnote_space_;
  double width_, height_;
};

}  // namespace

drawing::ChartAxis colour_axis(std::string label, std::vector<double> positive) {
  if (positive.empty()) return drawing::logarithmic_axis(std::move(label), 0, 0);
  const double low = percentile(positive, 1);
  return drawing::logarithmic_axis(std::move(label), low,
                                   *std::max_element(positive.begin(), positive.end()));
}

std::string HemisphereFigure::svg() const { return FigureDrawing(*this).svg(); }

}  // namespace brdftab

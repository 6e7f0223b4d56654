#include "host/pictures/drawing/chart.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "host/pictures/drawing/chart_layout.hpp"
#include "host/pictures/drawing/picture_data.hpp"

namespace brdftab::drawing {
namespace {

// Lines go on beyond the frame, which clips them, but renderers refuse very large numbers.
constexpr double farthest_up = -2000;
constexpr double farthest_down = 4000;

class ChartDrawing {
 public:
  explicit ChartDrawing(const Chart& chart) : chart_(chart), layout_(lay_out(chart)) {}

  std::string svg() const {
    Svg svg(layout_.width, layout_.height);
    svg.text(chart_sizes::margin, 26, chart_.title,
             {.anchor = "start", .size = chart_sizes::title, .bold = true});
    svg.text(chart_sizes::margin, 45, chart_.subtitle,
             {.anchor = "start", .size = chart_sizes::subtitle, .ink = inks::faint_text});
    for (std::size_t k = 0; k < chart_.panels.size(); ++k) draw(svg, k);
    draw_legend(svg);
    return svg.document(plain_text(chart_.title), json_text(data()));
  }

 private:
  // An index among the entries of the legend; their number for a series without a label.
  std::size_t entry_of(const std::string& label) const {
    const auto at = std::find_if(layout_.legend.begin(), layout_.legend.end(),
                                 [&](const LegendEntry& entry) { return entry.label == label; });
    return static_cast<std::size_t>(at - layout_.legend.begin());
  }

  Ink ink_of(const std::string& label) const {
    const std::size_t k = entry_of(label);
    if (k == layout_.legend.size()) return inks::text;
    return chart_.colours == Colours::steps ? step_ink(k, layout_.legend.size()) : category_ink(k);
  }

  std::string dash(const std::string& label) const {
    return chart_.colours == Colours::steps ? "" : dash_of(entry_of(label));
  }

  template <class Frame>
  void draw_dots(Svg& svg, const Frame& frame, const Series& series, const Box& box) const {
    svg.begin_group(svg.fill(ink_of(series.label)));
    for (const ChartPoint& point : series.points) {
      const ChartPoint at = frame.place(point);
      if (at.x >= box.left - 1 && at.x <= box.right + 1 && at.y <= box.bottom + 1 && at.y >= box.top - 1)
        svg.dot(at.x, at.y, series.size);
    }
    svg.end_group();
  }

  template <class Frame>
  void draw_line(Svg& svg, const Frame& frame, const Series& series) const {
    std::string d;
    for (const ChartPoint& point : series.points) {
      const ChartPoint at = frame.place(point);
      d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", at.x,
                       std::clamp(at.y, farthest_up, farthest_down));
    }
    if (!d.empty())
      svg.path(d, ink_of(series.label), series.size, dash(series.label), "stroke-linejoin=\"round\"");
  }

  template <class Frame>
  void draw_in(Svg& svg, const Frame& frame, const Panel& panel, const Box& box, const Shown& shown) const {
    frame.draw(svg, shown);
    frame.clip(svg);
    for (const Rule& rule : panel.rules) {
      const double y = frame.place({panel.x.low, rule.y}).y;
      svg.line(box.left, y, box.right, y, inks::text, 1, "6 4");
    }
    for (const Series& series : panel.series)
      if (series.dots)
        draw_dots(svg, frame, series, box);
      else
        draw_line(svg, frame, series);
    svg.end_group();
    for (const Rule& rule : panel.rules)
      svg.text(box.right - 6, frame.place({panel.x.low, rule.y}).y - 5, rule.label,
               {.anchor = "end", .size = 11, .ink = inks::faint_text, .halo = true});
  }

  void draw(Svg& svg, std::size_t k) const {
    const Panel& panel = chart_.panels[k];
    const Box& box = layout_.boxes[k];
    if (!panel.title.empty())
      svg.text(box.left, box.top - 9, panel.title,
               {.anchor = "start", .size = chart_sizes::panel_title, .bold = true});
    if (!panel.heading.empty())
      svg.text(chart_sizes::margin, box.top - 9 - chart_sizes::panel_title_space, panel.heading,
               {.anchor = "start", .size = chart_sizes::heading});
    if (chart_.polar)
      draw_in(svg, PolarFrame(box, panel.x, panel.y), panel, box, layout_.shown[k]);
    else
      draw_in(svg, RectangularFrame(box, panel.x, panel.y), panel, box, layout_.shown[k]);
    if (!panel.note.empty()) svg.text(box.middle_x(), box.middle_y(), panel.note, {.ink = inks::faint_text});
  }

  void draw_legend(Svg& svg) const {
    using namespace chart_sizes;
    const auto& entries = layout_.legend;
    if (entries.empty()) return;
    const std::size_t rows = layout_.legend_rows;
    double y = layout_.boxes.front().top + 10;
    if (!chart_.legend_title.empty()) {
      svg.text(layout_.legend_left, y, chart_.legend_title,
               {.anchor = "start", .size = chart_sizes::legend, .bold = true});
      y += legend_step + 2;
    }
    for (std::size_t k = 0; k < entries.size(); ++k) {
      const double x = layout_.legend_left + layout_.legend_column_width * static_cast<double>(k / rows);
      const double at = y + legend_step * static_cast<double>(k % rows);
      const Ink ink = ink_of(entries[k].label);
      if (entries[k].line) svg.line(x, at - 4, x + mark_width, at - 4, ink, 2.2, dash(entries[k].label));
      if (entries[k].dots) svg.disc(x + 0.5 * mark_width, at - 4, 2.6, ink);
      svg.text(x + mark_width + mark_gap, at, entries[k].label,
               {.anchor = "start", .size = chart_sizes::legend});
    }
    y += legend_step * static_cast<double>(std::min(rows, entries.size())) + 4;
    for (const auto& note : chart_.notes) {
      svg.text(layout_.legend_left, y, note,
               {.anchor = "start", .size = chart_sizes::legend - 1, .ink = inks::faint_text});
      y += note_step;
    }
  }

  // An axis with the places on the page of its two ends.
  static nlohmann::ordered_json placed_axis(const ChartAxis& axis, double from, double to) {
    auto data = axis_data(axis);
    data["from"] = hundredths(from);
    data["to"] = hundredths(to);
    return data;
  }

  static nlohmann::ordered_json series_data(const Series& series) {
    auto x = nlohmann::ordered_json::array(), y = nlohmann::ordered_json::array();
    for (const ChartPoint& point : series.points) {
      x.push_back(nine_digits(point.x));
      y.push_back(nine_digits(point.y));
    }
    return {{"label", text_data(series.label)},
            {"marks", series.dots ? "dots" : "line"},
            {"x", std::move(x)},
            {"y", std::move(y)}};
  }

  nlohmann::ordered_json data() const {
    auto panels = nlohmann::ordered_json::array();
    for (std::size_t k = 0; k < chart_.panels.size(); ++k) {
      const Panel& panel = chart_.panels[k];
      const Box& box = layout_.boxes[k];
      auto all = nlohmann::ordered_json::array();
      for (const Series& series : panel.series) all.push_back(series_data(series));
      panels.push_back({{"title", text_data(panel.title)},
                        {"x", placed_axis(panel.x, box.left, box.right)},
                        {"y", placed_axis(panel.y, box.bottom, box.top)},
                        {"series", std::move(all)}});
    }
    return {{"title", text_data(chart_.title)}, {"polar", chart_.polar}, {"panels", std::move(panels)}};
  }

  const Chart& chart_;
  const ChartLayout layout_;
};

}  // namespace

std::string Chart::svg() const { return ChartDrawing(*this).svg(); }

}  // namespace brdftab::drawing

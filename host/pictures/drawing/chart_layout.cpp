#include "host/pictures/drawing/chart_layout.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdftab::drawing {
namespace {

using namespace chart_sizes;

constexpr double usual_width = 760;
constexpr double narrowest_panel = 200;
constexpr double panel_gap = 30;
constexpr double heading_space = 26;
constexpr double legend_gap = 18;
constexpr double no_axis_space = 14;

std::vector<LegendEntry> legend_of(const Chart& chart) {
  std::vector<LegendEntry> entries;
  for (const Panel& panel : chart.panels)
    for (const Series& series : panel.series) {
      if (series.label.empty()) continue;
      auto at = std::find_if(entries.begin(), entries.end(),
                             [&](const LegendEntry& entry) { return entry.label == series.label; });
      if (at == entries.end()) at = entries.insert(entries.end(), {series.label});
      (series.dots ? at->dots : at->line) = true;
    }
  return entries;
}

// Panels that share an axis with their neighbour leave its numbers to that one.
Shown shown_axes(const Chart& chart, std::size_t k, std::size_t columns) {
  const auto& panels = chart.panels;
  return {chart.polar || k + columns >= panels.size() || !(panels[k].x == panels[k + columns].x),
          chart.polar || k % columns == 0 || !(panels[k].y == panels[k - 1].y)};
}

// The legend has as many rows as fit into `room`. Returns its width with the gap before it, 0 without a
// legend.
double measure_legend(const Chart& chart, double room, ChartLayout& layout) {
  layout.legend_rows = std::max<std::size_t>(static_cast<std::size_t>(room / legend_step), 1);
  const std::size_t columns = (layout.legend.size() + layout.legend_rows - 1) / layout.legend_rows;
  double widest = 0;
  for (const LegendEntry& entry : layout.legend)
    widest = std::max(widest, text_width(entry.label, chart_sizes::legend));
  layout.legend_column_width = mark_width + mark_gap + widest + 12;
  double width = static_cast<double>(columns) * layout.legend_column_width;
  width = std::max(width, text_width(chart.legend_title, chart_sizes::legend, true));
  for (const auto& note : chart.notes) width = std::max(width, text_width(note, chart_sizes::legend - 1));
  return width > 0 ? width + legend_gap : 0;
}

// `before` holds the space before each column of panels, `below` the space below each row.
void place_panels(const Chart& chart, double panel_width, double panel_height,
                  const std::vector<double>& before, const std::vector<double>& below, ChartLayout& layout) {
  const bool titled = std::any_of(chart.panels.begin(), chart.panels.end(),
                                  [](const Panel& panel) { return !panel.title.empty(); });
  double y = chart.subtitle.empty() ? 40 : 58;
  for (std::size_t row = 0; row < below.size(); ++row) {
    if (!chart.panels[row * before.size()].heading.empty()) y += heading_space;
    if (titled) y += panel_title_space;
    double x = margin;
    for (const double space : before) {
      x += space;
      layout.boxes.push_back({x, y, x + panel_width, y + panel_height});
      x += panel_width;
    }
    y += panel_height + below[row];
    layout.legend_left = x + legend_gap;
  }
  layout.height = std::ceil(y + margin / 2);
}

}  // namespace

ChartLayout lay_out(const Chart& chart) {
  ChartLayout layout;
  layout.legend = legend_of(chart);
  const std::size_t columns = std::min(chart.columns, chart.panels.size());
  const std::size_t rows = (chart.panels.size() + columns - 1) / columns;
  std::vector<double> before(columns, 0), below(rows, no_axis_space);
  for (std::size_t k = 0; k < chart.panels.size(); ++k) {
    layout.shown.push_back(shown_axes(chart, k, columns));
    if (!chart.polar && layout.shown[k].y) before[k % columns] = y_axis_space;
    if (layout.shown[k].x) below[k / columns] = x_axis_space;
  }
  for (std::size_t column = 1; column < columns; ++column) before[column] += panel_gap;
  // The legend's width follows from the height of the panels, and the panels' width from that of the legend.
  const double panel_height = chart.panel_height > 0      ? chart.panel_height
                              : columns == 1 && rows == 1 ? 380
                                                          : 230;
  const double legend_width = measure_legend(
      chart,
      panel_height * static_cast<double>(rows) - 20 - note_step * static_cast<double>(chart.notes.size()),
      layout);
  const double taken = std::accumulate(before.begin(), before.end(), 2 * margin);
  double panel_width =
      chart.panel_width > 0
          ? chart.panel_width
          : std::max((usual_width - taken - legend_width) / static_cast<double>(columns), narrowest_panel);
  for (const Panel& panel : chart.panels)
    panel_width = std::max(panel_width, text_width(panel.title, chart_sizes::panel_title, true));
  place_panels(chart, panel_width, panel_height, before, below, layout);
  layout.width = std::ceil(std::max({layout.legend_left - legend_gap + legend_width + margin,
                                     2 * margin + text_width(chart.title, chart_sizes::title, true),
                                     2 * margin + text_width(chart.subtitle, chart_sizes::subtitle)}));
  return layout;
}

}  // namespace brdftab::drawing

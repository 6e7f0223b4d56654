// Where the panels of a chart and its legend lie on the page.
#pragma once

#include <string>
#include <vector>

#include "host/pictures/drawing/chart.hpp"
#include "host/pictures/drawing/frame.hpp"

namespace brdftab::drawing {

/// Sizes of a chart's texts, and spaces between its parts, in user units.
namespace chart_sizes {
inline constexpr double margin = 14;
inline constexpr double title = 16;
inline constexpr double subtitle = 12.5;
inline constexpr double heading = 14;
inline constexpr double panel_title = 13;
inline constexpr double panel_title_space = 24;
inline constexpr double legend = 12.5;
inline constexpr double legend_step = 18;
inline constexpr double note_step = 16;
inline constexpr double mark_width = 26;
inline constexpr double mark_gap = 8;  // between a mark of the legend and its label
}  // namespace chart_sizes

/// Series with one label share an entry of the legend, which shows their kinds of mark.
struct LegendEntry {
  std::string label;
  bool line = false;
  bool dots = false;
};

struct ChartLayout {
  std::vector<LegendEntry> legend;
  std::vector<Box> boxes;    // one for each panel
  std::vector<Shown> shown;  // one for each panel
  double legend_left = 0;
  double legend_column_width = 0;
  std::size_t legend_rows = 1;
  double width = 0, height = 0;
};

ChartLayout lay_out(const Chart& chart);

}  // namespace brdftab::drawing

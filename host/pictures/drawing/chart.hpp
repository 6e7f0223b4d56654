// A chart: panels of lines and dots, which share one legend.
#pragma once

#include <string>
#include <vector>

#include "host/pictures/drawing/frame.hpp"

namespace brdftab::drawing {

struct Series {
  std::string label;  // series with the same label share a colour and an entry of the legend
  std::vector<ChartPoint> points;
  bool dots = false;
  double size = 1.6;  // the width of a line, or the radius of dots, in user units
};

/// A dashed horizontal line with a name at a value of y.
struct Rule {
  double y;
  std::string label;
};

struct Panel {
  std::string title;
  ChartAxis x, y;
  std::vector<Series> series;
  std::vector<Rule> rules;
  std::string note;     // stands in the middle of an empty panel
  std::string heading;  // stands above the row of panels that this one begins

  void line(std::string label, std::vector<ChartPoint> points) {
    series.push_back({std::move(label), std::move(points)});
  }
  void dots(std::string label, std::vector<ChartPoint> points, double radius = 2) {
    series.push_back({std::move(label), std::move(points), true, radius});
  }
};

/// What the colours of a chart tell apart: kinds of thing, or steps of one quantity.
enum class Colours { categories, steps };

struct Chart {
  std::string title;  // Svg::text tells how this and all other texts of a chart are written
  std::string subtitle;
  std::string legend_title;
  std::vector<std::string> notes;  // stand below the entries of the legend
  Colours colours = Colours::categories;
  bool polar = false;
  std::size_t columns = 1;
  // Sizes of a panel are in user units. The width 0 makes the chart about 760 wide; the height 0 suits the
  // number of panels.
  double panel_width = 0;
  double panel_height = 0;
  std::vector<Panel> panels;

  /// The text of an SVG file. Its metadata hold the axes and the series of each panel as JSON.
  std::string svg() const;
};

}  // namespace brdftab::drawing

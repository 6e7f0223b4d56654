// A chart: panels of lines and dots, one legend for all.
#pragma once

#include <string>
#include <vector>

#include "host/pictures/drawing/frame.hpp"

namespace brdftab {

struct Series {
  std::string label;  // series of one label share a colour and an entry of the legend
  std::vector<ChartPoint> points;
  bool dots = false;
  double size = 1.6;  // width of a line, radius of dots
};

/// A horizontal line at a value of y, with a name.
struct Rule {
  double y;
  std::string label;
};

struct Panel {
  std::string title;
  ChartAxis x, y;
  std::vector<Series> series;
  std::vector<Rule> rules;
  std::string note;     // in the middle of an empty panel
  std::string heading;  // above the row of panels that this one begins

  void line(std::string label, std::vector<ChartPoint> points) {
    series.push_back({std::move(label), std::move(points)});
  }
  void dots(std::string label, std::vector<ChartPoint> points, double radius = 2) {
    series.push_back({std::move(label), std::move(points), true, radius});
  }
};

/// What the colours of a chart tell apart.
enum class Colours { categories, steps };

struct Chart {
  std::string title;     // as Svg::text takes it, like all texts of a chart
  std::string subtitle;  // smaller, below
  std::string legend_title;
  std::vector<std::string> notes;  // below the legend's entries
  Colours colours = Colours::categories;
  bool polar = false;
  std::size_t columns = 1;
  double panel_width = 0;  // 0: so that the chart is about 760 wide
  double panel_height = 0;
  std::vector<Panel> panels;

  /// The file; its metadata hold every panel's axes and series as JSON, at nine digits.
  std::string svg() const;
};

}  // namespace brdftab

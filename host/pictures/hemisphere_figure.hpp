// Maps of the hemisphere of scatter directions, which share one scale of colours.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/drawing/palette.hpp"
#include "host/pictures/hemisphere_pixels.hpp"

namespace brdftab {

struct MarkedDirection {
  double theta_s, phi;  // degrees
};

struct HemisphereMap {
  std::string title;
  double theta_i;              // degrees
  std::vector<double> values;  // at the pixels of HemisphereFigure; nothing is drawn where one is nan
  std::optional<MarkedDirection> marked = std::nullopt;
  std::string heading = "";  // above the row of maps that this one begins
};

/// A logarithmic axis for the colours of positive values. It ends at the largest, and begins where 1 % of the
/// values are below it, but spans at most 7 decades.
drawing::ChartAxis colour_axis(std::string label, std::vector<double> positive);

struct HemisphereFigure {
  std::string title;
  std::string subtitle;
  std::string footnote;
  drawing::ChartAxis scale;  // of the colours
  const drawing::ColourScale* colours = &drawing::viridis;
  std::size_t columns = 4;  // the maps in a row at most
  std::vector<HemisphereMap> maps;

  /// The pixels for which each map holds its values.
  static HemispherePixels pixels() { return HemispherePixels(420); }

  /// The text of an SVG file. Its metadata hold the scale and the place of each map as JSON.
  std::string svg() const;
};

}  // namespace brdftab

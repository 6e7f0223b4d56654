// Maps of the hemisphere of scatter directions in direction cosines, beside each other under one scale of
// colours.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "host/model/direction_list.hpp"
#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/drawing/palette.hpp"

namespace brdftab {

/// Directions of the pixels of a map, which is 2 wide in direction cosines; rows run from sin theta_s sin phi
/// = 1 downwards.
class HemispherePixels {
 public:
  explicit HemispherePixels(std::size_t side) : side_(side) {}

  std::size_t side() const { return side_; }
  /// Polar angle and phi, in degrees, of a pixel's centre, drawn in to theta_s = 89.9 from beyond; none where
  /// it lies outside the disc by more than two pixels.
  std::optional<DirectionPair> direction(double theta_i, std::size_t row, std::size_t column) const;
  /// Values of an even function of phi at every pixel, evaluated on one half; nan outside the disc.
  std::vector<double> values(
      double theta_i,
      const std::function<std::vector<double>(std::span<const DirectionPair>)>& function) const;

 private:
  std::size_t side_;
};

struct MarkedDirection {
  double theta_s, phi;  // degrees
};

struct HemisphereMap {
  std::string title;
  double theta_i;
  std::vector<double> values;  // of HemispherePixels; nan: nothing is drawn
  std::optional<MarkedDirection> marked = std::nullopt;
  std::string heading = "";  // above the row that this map begins
};

/// A logarithmic axis for colours: from the value that 1 % of `positive` are below, at most 7 decades under
/// the largest.
ChartAxis colour_axis(std::string label, std::vector<double> positive);

struct HemisphereFigure {
  std::string title;
  std::string subtitle;
  std::string footnote;
  ChartAxis scale;  // of the colours
  const ColourScale* colours = &viridis;
  std::size_t columns = 4;
  std::vector<HemisphereMap> maps;

  /// Pixels for which `maps` hold values.
  static HemispherePixels pixels() { return HemispherePixels(420); }

  std::string svg() const;
};

}  // namespace brdftab

// A chart of lines and points as SVG text.
#pragma once

#include <string>
#include <vector>

namespace brdftab {

struct ChartAxis {
  std::string label;
  double low;
  double high;
  bool logarithmic = false;
};

struct ChartPoint {
  double x;
  double y;
};

class SvgChart {
 public:
  SvgChart(std::string title, ChartAxis x, ChartAxis y);
  /// Series of one label share a colour: the next of a palette at its first use.
  void line(const std::string& label, const std::vector<ChartPoint>& points);
  void dots(const std::string& label, const std::vector<ChartPoint>& points);
  std::string text() const;

 private:
  std::string colour(const std::string& label);
  double x_of(double x) const;
  double y_of(double y) const;
  bool is_inside(const ChartPoint& point) const;

  std::string title_;
  ChartAxis x_;
  ChartAxis y_;
  std::string body_;
  std::vector<std::string> labels_;
};

/// A square of coloured cells with names along both sides; values from -1 (blue) to 1 (red).
std::string svg_matrix(const std::string& title, const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& values);

}  // namespace brdftab

// An axis of a chart: its range, its scale and its ticks.
#pragma once

#include <string>
#include <vector>

namespace brdftab {

struct ChartAxis {
  std::string label;
  double low;
  double high;
  bool logarithmic = false;
  double step = 0;  // between labels of a linear axis; 0: a step of 1, 2 or 5 that gives about six

  /// 0 at `low`, 1 at `high`; below 0 where a logarithm does not exist.
  double position(double value) const;

  bool operator==(const ChartAxis&) const = default;
};

struct Tick {
  double value;
  std::string label;  // as Svg::text takes it; empty for the small ticks between labels
};

/// In increasing order.
std::vector<Tick> ticks(const ChartAxis& axis);

/// A logarithmic axis around positive values, its ends at 1, 2 or 5 times a power of ten; what lies more than
/// `most_decades` below the largest is left out. Without any positive value, 0.1 to 1.
ChartAxis logarithmic_axis(std::string label, double smallest, double largest, double most_decades = 7);

/// A number as labels show it: a true minus, powers of ten raised.
std::string number_label(double value);

}  // namespace brdftab

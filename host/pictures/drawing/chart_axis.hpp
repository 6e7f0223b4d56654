// An axis of a chart has a range, a linear or logarithmic scale, and ticks.
#pragma once

#include <string>
#include <vector>

namespace brdftab::drawing {

struct ChartAxis {
  std::string label;
  double low;
  double high;
  bool logarithmic = false;
  double step = 0;  // from one label of a linear axis to the next; 0 chooses one that gives about six

  /// Where a value lies on the axis: 0 is the place of `low`, 1 that of `high`. A value without a logarithm
  /// is at -1 on a logarithmic axis.
  double position(double value) const;

  bool operator==(const ChartAxis&) const = default;
};

struct Tick {
  double value;
  std::string label;  // is written as for Svg::text; the small ticks between labels have none
};

/// The ticks of an axis in increasing order.
std::vector<Tick> ticks(const ChartAxis& axis);

/// A logarithmic axis for values from `smallest` to `largest`. Its ends are 1, 2 or 5 times a power of ten,
/// and it leaves out what lies more than `most_decades` below the largest. It is 0.1 to 1 where the largest
/// is not positive.
ChartAxis logarithmic_axis(std::string label, double smallest, double largest, double most_decades = 7);

/// A number as labels show it, with a typographic minus and with powers of ten.
std::string number_label(double value);

}  // namespace brdftab::drawing

// Where values lie on the page: a rectangle of two axes, or half a disc of an angle and a radius.
#pragma once

#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab {

struct ChartPoint {
  double x;
  double y;
};

/// Which axes of a panel show their numbers and names; panels beside each other may share them.
struct Shown {
  bool x = true;
  bool y = true;
};

/// Rectangular axes.
class RectangularFrame {
 public:
  RectangularFrame(const Box& box, const ChartAxis& x, const ChartAxis& y) : box_(box), x_(x), y_(y) {}

  /// In user units; values beyond an axis lie beyond the box.
  ChartPoint place(const ChartPoint& point) const;
  void draw(Svg& svg, const Shown& shown) const;
  void clip(Svg& svg) const { svg.clip_to(box_); }

 private:
  Box box_;
  ChartAxis x_, y_;
};

/// x is an angle from the normal in degrees, -90 (left) to 90; y is the radius from the middle of the lower
/// side, which is 0 where y is at or below the low end of its axis.
class PolarFrame {
 public:
  PolarFrame(const Box& box, const ChartAxis& x, const ChartAxis& y);

  ChartPoint place(const ChartPoint& point) const;
  void draw(Svg& svg, const Shown& shown) const;
  void clip(Svg& svg) const { svg.clip_to(box_); }

 private:
  Box box_;
  ChartAxis x_, y_;
  double radius_;
  ChartPoint origin_;
};

/// Space that the numbers and names of an axis take beside a frame.
inline constexpr double x_axis_space = 46;
inline constexpr double y_axis_space = 64;

}  // namespace brdftab

// A frame turns values into places on the page: a rectangle has two axes, half a disc an angle and a radius.
#pragma once

#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab::drawing {

struct ChartPoint {
  double x;
  double y;
};

/// Which axes of a panel show their numbers and names: panels beside each other may share them.
struct Shown {
  bool x = true;
  bool y = true;
};

class RectangularFrame {
 public:
  RectangularFrame(const Box& box, const ChartAxis& x, const ChartAxis& y) : box_(box), x_(x), y_(y) {}

  /// The place of a point in user units. It is outside the box where the point is beyond an axis.
  ChartPoint place(const ChartPoint& point) const;
  void draw(Svg& svg, const Shown& shown) const;
  void clip(Svg& svg) const { svg.clip_to(box_); }

 private:
  Box box_;
  ChartAxis x_, y_;
};

/// x is an angle from the normal in degrees, from -90 on the left to 90 on the right. y is the distance from
/// the middle of the lower side, where everything lies that is at or below the low end of the axis of y.
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

/// The numbers and the name of an axis take this space beside a frame, in user units.
inline constexpr double x_axis_space = 46;
inline constexpr double y_axis_space = 64;

}  // namespace brdftab::drawing

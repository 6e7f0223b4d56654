#include "host/pictures/drawing/frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"

namespace brdftab::drawing {
namespace {

constexpr double long_tick = 5;
constexpr double short_tick = 3;
constexpr double number_size = 12;
constexpr double name_size = 13;
constexpr double least_gap = 18;  // between the numbers of a radius

}  // namespace

ChartPoint RectangularFrame::place(const ChartPoint& point) const {
  return {box_.left + box_.width() * x_.position(point.x),
          box_.bottom - box_.height() * y_.position(point.y)};
}

void RectangularFrame::draw(Svg& svg, const Shown& shown) const {
  for (const Tick& tick : ticks(x_)) {
    const double x = place({tick.value, y_.low}).x;
    const bool labelled = !tick.label.empty();
    if (labelled && x > box_.left + 1 && x < box_.right - 1)
      svg.line(x, box_.top, x, box_.bottom, inks::grid);
    svg.line(x, box_.bottom, x, box_.bottom + (labelled ? long_tick : short_tick), inks::frame);
    if (labelled && shown.x) svg.text(x, box_.bottom + 19, tick.label, {.size = number_size});
  }
  for (const Tick& tick : ticks(y_)) {
    const double y = place({x_.low, tick.value}).y;
    const bool labelled = !tick.label.empty();
    if (labelled && y > box_.top + 1 && y < box_.bottom - 1)
      svg.line(box_.left, y, box_.right, y, inks::grid);
    svg.line(box_.left - (labelled ? long_tick : short_tick), y, box_.left, y, inks::frame);
    if (labelled && shown.y)
      svg.text(box_.left - 8, y + 4.3, tick.label, {.anchor = "end", .size = number_size});
  }
  svg.rectangle(box_, inks::frame);
  if (shown.x) svg.text(box_.middle_x(), box_.bottom + 39, x_.label, {.size = name_size});
  if (shown.y)
    svg.text(box_.left - y_axis_space + 14, box_.middle_y(), y_.label, {.size = name_size, .turned = -90});
}

PolarFrame::PolarFrame(const Box& box, const ChartAxis& x, const ChartAxis& y)
    : box_(box),
      x_(x),
      y_(y),
      radius_(std::min(0.5 * box.width() - 34, box.height() - 26)),
      origin_{box.middle_x(), box.bottom} {}

ChartPoint PolarFrame::place(const ChartPoint& point) const {
  const double radius = radius_ * std::max(y_.position(point.y), 0.0);
  const double angle = radians(point.x);
  return {origin_.x + radius * std::sin(angle), origin_.y - radius * std::cos(angle)};
}

void PolarFrame::draw(Svg& svg, const Shown& shown) const {
  const auto arc = [&](double radius, const Ink& ink) {
    svg.path(fmt::format("M{0:.2f} {1:.2f}A{2:.2f} {2:.2f} 0 0 1 {3:.2f} {1:.2f}", origin_.x - radius,
                         origin_.y, radius, origin_.x + radius),
             ink, 1);
  };
  for (int angle = -90; angle <= 90; angle += 10) {
    const bool labelled = angle % 30 == 0;
    const ChartPoint rim = place({static_cast<double>(angle), y_.high});
    const double turn = radians(angle);
    const double tick = labelled ? long_tick : short_tick;
    if (labelled && angle != -90 && angle != 90) svg.line(origin_.x, origin_.y, rim.x, rim.y, inks::grid);
    svg.line(rim.x, rim.y, rim.x + tick * std::sin(turn), rim.y - tick * std::cos(turn), inks::frame);
    if (labelled && shown.x)
      svg.text(rim.x + 18 * std::sin(turn), rim.y - 12 * std::cos(turn) + 4,
               fmt::format("{}°", number_label(angle)), {.size = number_size, .ink = inks::text});
  }
  double last = HUGE_VAL;
  auto radii = ticks(y_);
  std::reverse(radii.begin(), radii.end());
  for (const Tick& tick : radii) {
    if (tick.label.empty()) continue;
    const double radius = radius_ * y_.position(tick.value);
    if (radius > 1 && radius < radius_ - 1) arc(radius, inks::grid);
    // The numbers stand below the line of the surface, on both sides, where they do not touch each other.
    if (!shown.y || last - radius < std::max(least_gap, text_width(tick.label, number_size) + 8)) continue;
    last = radius;
    svg.line(origin_.x + radius, origin_.y, origin_.x + radius, origin_.y + long_tick, inks::frame);
    if (radius > 1)
      svg.line(origin_.x - radius, origin_.y, origin_.x - radius, origin_.y + long_tick, inks::frame);
    svg.text(origin_.x + radius, origin_.y + 19, tick.label, {.size = number_size});
    if (radius > 1) svg.text(origin_.x - radius, origin_.y + 19, tick.label, {.size = number_size});
  }
  arc(radius_, inks::frame);
  svg.line(origin_.x - radius_, origin_.y, origin_.x + radius_, origin_.y, inks::frame);
  if (shown.y) svg.text(origin_.x, origin_.y + 39, y_.label, {.size = name_size});
}

}  // namespace brdftab::drawing

#include "host/pictures/drawing/smooth_curve.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab::drawing {
namespace {

constexpr double page_width = 600;
constexpr double page_height = 400;
constexpr double tolerance = 0.1;
constexpr double x_grain = 1e-7;

double rounded(double x) { return std::round(x / x_grain) * x_grain; }

// The distance of a point from the line through two others.
double off_chord(const ChartPoint& a, const ChartPoint& middle, const ChartPoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  return std::abs(dx * (middle.y - a.y) - dy * (middle.x - a.x)) / std::hypot(dx, dy);
}

struct Interval {
  std::size_t curve;
  ChartPoint begin, end;
};

}  // namespace

std::vector<double> curve_starts(double first, double last, double step, std::span<const double> more) {
  std::vector<double> places{first, last};
  for (double x = std::ceil(first / step) * step; x < last; x += step) places.push_back(x);
  for (const double x : more)
    if (x > first && x < last) places.push_back(x);
  for (double& x : places) x = rounded(x);
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

std::vector<std::vector<ChartPoint>> smooth_curves(const std::vector<std::vector<double>>& starts,
                                                   const CurveValues& values, bool logarithmic,
                                                   double most_decades) {
  std::vector<CurvePlace> places;
  for (std::size_t curve = 0; curve < starts.size(); ++curve)
    for (const double x : starts[curve]) places.push_back({curve, x});
  auto y = values(places);
  const double largest = *std::max_element(y.begin(), y.end());
  const double floor = logarithmic ? largest * std::pow(10, -most_decades) : -HUGE_VAL;
  const double lowest = std::max(*std::min_element(y.begin(), y.end()), floor);
  const auto height = [&](double value) { return logarithmic ? std::log(std::max(value, floor)) : value; };
  double first = HUGE_VAL, last = -HUGE_VAL;
  for (const auto& places_of_curve : starts) {
    first = std::min(first, places_of_curve.front());
    last = std::max(last, places_of_curve.back());
  }
  const double x_scale = page_width / (last - first);
  const double range = height(largest) - height(lowest);
  const double y_scale = range > 0 ? page_height / range : 1;
  const auto on_page = [&](const ChartPoint& point) {
    return ChartPoint{point.x * x_scale, height(point.y) * y_scale};
  };

  std::vector<std::vector<ChartPoint>> curves(starts.size());
  for (std::size_t k = 0; k < places.size(); ++k) curves[places[k].curve].push_back({places[k].x, y[k]});
  if (largest <= 0 && logarithmic) return curves;
  std::vector<Interval> open;
  for (std::size_t curve = 0; curve < curves.size(); ++curve)
    for (std::size_t k = 1; k < curves[curve].size(); ++k)
      open.push_back({curve, curves[curve][k - 1], curves[curve][k]});
  while (!open.empty()) {
    places.clear();
    std::erase_if(open,
                  [](const Interval& interval) { return interval.end.x - interval.begin.x < 4 * x_grain; });
    for (const auto& interval : open)
      places.push_back({interval.curve, rounded(0.5 * (interval.begin.x + interval.end.x))});
    if (places.empty()) break;
    y = values(places);
    std::vector<Interval> next;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const ChartPoint middle{places[k].x, y[k]};
      if (off_chord(on_page(open[k].begin), on_page(middle), on_page(open[k].end)) <= tolerance) continue;
      curves[open[k].curve].push_back(middle);
      next.push_back({open[k].curve, open[k].begin, middle});
      next.push_back({open[k].curve, middle, open[k].end});
    }
    open = std::move(next);
  }
  for (auto& curve : curves)
    std::sort(curve.begin(), curve.end(), [](const ChartPoint& a, const ChartPoint& b) { return a.x < b.x; });
  return curves;
}

}  // namespace brdftab::drawing

#include "host/pictures/drawing/chart_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdftab::drawing {
namespace {

constexpr double slack = 1e-9;
constexpr std::size_t fewest_labels = 4;

bool within(const ChartAxis& axis, double value) {
  const double room = slack * (axis.logarithmic ? value : axis.high - axis.low);
  return value >= axis.low - room && value <= axis.high + room;
}

double round_step(double rough) {
  const double power = std::pow(10, std::floor(std::log10(rough)));
  return power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : rough / power > 1 ? 2 : 1);
}

std::vector<Tick> linear_ticks(const ChartAxis& axis) {
  const double step = axis.step > 0 ? axis.step : round_step((axis.high - axis.low) / 6);
  // Small ticks divide a given step, such as 30 degrees, into thirds; a step of 2 into quarters, 1 or 5 into
  // fifths.
  const double mantissa = step / std::pow(10, std::floor(std::log10(step) + slack));
  const int parts = axis.step > 0 ? 3 : std::abs(mantissa - 2) < slack ? 4 : 5;
  std::vector<Tick> result;
  for (double k = std::ceil(axis.low / step * parts - slack); k * step / parts <= axis.high + slack * step;
       ++k) {
    const bool labelled = std::fmod(k, parts) == 0;
    result.push_back({k * step / parts, labelled ? number_label(k / parts * step) : ""});
  }
  return result;
}

std::vector<Tick> logarithmic_ticks(const ChartAxis& axis) {
  const auto first = static_cast<int>(std::floor(std::log10(axis.low) + slack));
  const auto last = static_cast<int>(std::floor(std::log10(axis.high) + slack));
  std::vector<Tick> all;
  for (int decade = first; decade <= last; ++decade)
    for (int m = 1; m <= 9; ++m)
      if (const double value = m * std::pow(10, decade); within(axis, value)) all.push_back({value, ""});
  const std::array<std::vector<int>, 3> mantissas{std::vector{1}, {1, 2, 5}, {1, 2, 3, 4, 5, 6, 7, 8, 9}};
  for (const auto& chosen : mantissas) {
    const auto is_chosen = [&](const Tick& tick) {
      const double mantissa = tick.value / std::pow(10, std::floor(std::log10(tick.value) + slack));
      return std::find(chosen.begin(), chosen.end(), std::lround(mantissa)) != chosen.end();
    };
    if (static_cast<std::size_t>(std::count_if(all.begin(), all.end(), is_chosen)) < fewest_labels) continue;
    for (Tick& tick : all)
      if (is_chosen(tick)) tick.label = number_label(tick.value);
    return all;
  }
  return linear_ticks({axis.label, axis.low, axis.high});
}

// The ends of axes are 1, 2 or 5 times a power of ten: this is the nearest one at or above a value, or at or
// below it.
double round_end(double value, bool above) {
  const double power = std::pow(10, std::floor(std::log10(value) + slack));
  const double mantissa = value / power;
  const std::array<double, 4> ends{1, 2, 5, 10};
  if (above)
    return power *
           *std::find_if(ends.begin(), ends.end(), [&](double end) { return end >= mantissa * (1 - slack); });
  return power *
         *std::find_if(ends.rbegin(), ends.rend(), [&](double end) { return end <= mantissa * (1 + slack); });
}

}  // namespace

double ChartAxis::position(double value) const {
  if (!logarithmic) return (value - low) / (high - low);
  return value > 0 ? std::log(value / low) / std::log(high / low) : -1;
}

std::vector<Tick> ticks(const ChartAxis& axis) {
  return axis.logarithmic ? logarithmic_ticks(axis) : linear_ticks(axis);
}

ChartAxis logarithmic_axis(std::string label, double smallest, double largest, double most_decades) {
  if (!(largest > 0) || !std::isfinite(largest)) return {std::move(label), 0.1, 1, true};
  const double low = std::max(smallest / 1.05, largest * std::pow(10, -most_decades));
  return {std::move(label), round_end(low, false), round_end(largest * 1.05, true), true};
}

std::string number_label(double value) {
  const double size = std::abs(value);
  std::string text;
  if (size == 0 || (size > 0.99e-2 && size < 1e5)) {
    text = fmt::format("{:.6g}", size);
  } else {
    const double power = std::floor(std::log10(size) + slack);
    const std::string mantissa = fmt::format("{:.3g}", size / std::pow(10, power));
    text = fmt::format("{}10^{{{}{}}}", mantissa == "1" ? "" : mantissa + "·", power < 0 ? "−" : "",
                       std::abs(power));
  }
  return value < 0 ? "−" + text : text;
}

}  // namespace brdftab::drawing

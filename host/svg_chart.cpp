#include "host/svg_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brdftab {
namespace {

constexpr double width = 760;
constexpr double height = 480;
constexpr double left = 80;
constexpr double right = 620;  // the legend stands beside it
constexpr double top = 40;
constexpr double bottom = 420;
// Told apart by people who see no red or green, too (Okabe and Ito).
constexpr std::array<const char*, 8> palette{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                             "#e69f00", "#56b4e9", "#000000", "#999999"};

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '<' ? std::string("&lt;") : c == '&' ? std::string("&amp;") : std::string(1, c);
  return result;
}

std::string label_at(double x, double y, const std::string& text, const char* anchor = "middle", int size = 13) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" font-size=\"{}\">{}</text>\n", x, y, anchor, size,
                     escaped(text));
}

std::string head(double wide, double high) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
      "font-family=\"sans-serif\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      wide, high);
}

double position(const ChartAxis& axis, double value) {
  return axis.logarithmic ? std::log(value / axis.low) / std::log(axis.high / axis.low)
                          : (value - axis.low) / (axis.high - axis.low);
}

// Decades, or steps of 1, 2 or 5 that give about six.
std::vector<double> ticks(const ChartAxis& axis) {
  std::vector<double> result;
  if (axis.logarithmic) {
    for (double decade = std::pow(10, std::ceil(std::log10(axis.low) - 1e-9)); decade <= axis.high * (1 + 1e-9); decade *= 10)
      result.push_back(decade);
    return result;
  }
  const double rough = (axis.high - axis.low) / 6;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  const double step = power * (rough / power > 5 ? 10 : rough / power > 2 ? 5 : rough / power > 1 ? 2 : 1);
  for (double k = std::ceil(axis.low / step - 1e-9); k * step <= axis.high + 1e-9 * step; ++k) result.push_back(k * step);
  return result;
}

}  // namespace

SvgChart::SvgChart(std::string title, ChartAxis x, ChartAxis y) : title_(std::move(title)), x_(std::move(x)), y_(std::move(y)) {}

double SvgChart::x_of(double x) const { return left + (right - left) * position(x_, x); }
double SvgChart::y_of(double y) const { return bottom - (bottom - top) * position(y_, y); }

bool SvgChart::is_inside(const ChartPoint& point) const {
  return point.x >= x_.low && point.x <= x_.high && point.y >= y_.low && point.y <= y_.high;
}

std::string SvgChart::colour(const std::string& label) {
  auto at = std::find(labels_.begin(), labels_.end(), label);
  if (at == labels_.end()) at = labels_.insert(labels_.end(), label);
  return palette[static_cast<std::size_t>(at - labels_.begin()) % palette.size()];
}

void SvgChart::line(const std::string& label, const std::vector<ChartPoint>& points) {
  std::string path;
  bool drawn = false;
  for (const ChartPoint& point : points) {
    if (is_inside(point)) path += fmt::format("{}{:.2f} {:.2f}", drawn ? "L" : "M", x_of(point.x), y_of(point.y));
    drawn = is_inside(point);
  }
  body_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.5\"/>\n", path, colour(label));
}

void SvgChart::dots(const std::string& label, const std::vector<ChartPoint>& points) {
  body_ += fmt::format("<g fill=\"{}\">\n", colour(label));
  for (const ChartPoint& point : points)
    if (is_inside(point)) body_ += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"2\"/>\n", x_of(point.x), y_of(point.y));
  body_ += "</g>\n";
}

std::string SvgChart::text() const {
  std::string svg = head(width, height);
  svg += label_at((left + right) / 2, 24, title_, "middle", 15);
  for (const double tick : ticks(x_)) {
    svg += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/>\n", x_of(tick), top, bottom);
    svg += label_at(x_of(tick), bottom + 18, fmt::format("{:.4g}", tick));
  }
  for (const double tick : ticks(y_)) {
    svg += fmt::format("<path d=\"M{1} {0:.1f}H{2}\" stroke=\"#ddd\"/>\n", y_of(tick), left, right);
    svg += label_at(left - 8, y_of(tick) + 4, fmt::format("{:.4g}", tick), "end");
  }
  svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"none\" stroke=\"black\"/>\n", left, top,
                     right - left, bottom - top);
  svg += label_at((left + right) / 2, bottom + 42, x_.label);
  svg += fmt::format("<text transform=\"translate(22 {}) rotate(-90)\" text-anchor=\"middle\" font-size=\"13\">{}</text>\n",
                     (top + bottom) / 2, escaped(y_.label));
  svg += body_;
  for (std::size_t k = 0; k < labels_.size(); ++k) {
    const double y = top + 12 + 17 * static_cast<double>(k);
    svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"12\" height=\"4\" fill=\"{}\"/>\n", right + 14, y - 6,
                       palette[k % palette.size()]);
    svg += label_at(right + 32, y, labels_[k], "start", 12);
  }
  return svg + "</svg>\n";
}

std::string svg_matrix(const std::string& title, const std::vector<std::string>& names,
                       const std::vector<std::vector<double>>& values) {
  constexpr double cell = 36;
  constexpr double margin = 120;
  const double side = margin + cell * static_cast<double>(names.size());
  std::string svg = head(side + 20, side + 20);
  svg += label_at(side / 2, 20, title, "middle", 15);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double at = margin + cell * static_cast<double>(i);
    svg += label_at(margin - 6, at + cell / 2 + 4, names[i], "end", 12);
    svg += fmt::format("<text transform=\"translate({:.1f} {}) rotate(-60)\" font-size=\"12\">{}</text>\n", at + cell / 2,
                       margin - 6, escaped(names[i]));
    for (std::size_t j = 0; j < names.size(); ++j) {
      const double value = std::clamp(values[i][j], -1., 1.);
      const int faded = static_cast<int>(std::lround(255 * (1 - std::abs(value))));
      svg += fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"rgb({},{},{})\"/>\n",
                         margin + cell * static_cast<double>(j), at, cell, cell, value >= 0 ? 255 : faded, faded,
                         value >= 0 ? faded : 255);
      svg +=
          label_at(margin + cell * (static_cast<double>(j) + 0.5), at + cell / 2 + 4, fmt::format("{:.2f}", value), "middle", 10);
    }
  }
  return svg + "</svg>\n";
}

}  // namespace brdftab

#include "host/pictures/drawing/chart.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace brdftab {
namespace {

constexpr double margin = 14;
constexpr double title_size = 16;
constexpr double subtitle_size = 12.5;
constexpr double legend_size = 12.5;
constexpr double legend_step = 18;
constexpr double mark_width = 26;
constexpr double usual_width = 760;
constexpr double panel_gap = 30;
constexpr double panel_title_space = 24;
constexpr double panel_title_size = 13;
constexpr double heading_space = 26;
constexpr double heading_size = 14;

class Drawing {
 public:
  explicit Drawing(const Chart& chart) : chart_(chart) {
    for (const Panel& panel : chart.panels)
      for (const Series& series : panel.series) {
        if (series.label.empty()) continue;
        auto at = std::find_if(entries_.begin(), entries_.end(),
                               [&](const auto& entry) { return entry.label == series.label; });
        if (at == entries_.end()) at = entries_.insert(entries_.end(), {series.label});
        (series.dots ? at->dots : at->line) = true;
      }
    columns_ = std::min(chart.columns, chart.panels.size());
    rows_ = (chart.panels.size() + columns_ - 1) / columns_;
    lay_out();
  }

  std::string svg() const {
    Svg svg(width_, height_);
    svg.text(margin, 26, chart_.title, {.anchor = "start", .size = title_size, .bold = true});
    svg.text(margin, 45, chart_.subtitle,
             {.anchor = "start", .size = subtitle_size, .ink = inks::faint_text});
    for (std::size_t k = 0; k < chart_.panels.size(); ++k) draw(svg, k);
    draw_legend(svg);
    return svg.document(plain_text(chart_.title), data());
  }

 private:
  struct Entry {
    std::string label;
    bool line = false;
    bool dots = false;
  };

  bool shows_y(std::size_t k) const {
    return k % columns_ == 0 || !(chart_.panels[k].y == chart_.panels[k - 1].y);
  }
  bool shows_x(std::size_t k) const {
    return k + columns_ >= chart_.panels.size() || !(chart_.panels[k].x == chart_.panels[k + columns_].x);
  }

  void lay_out() {
    const bool titled = std::any_of(chart_.panels.begin(), chart_.panels.end(),
                                    [](const auto& p) { return !p.title.empty(); });
    const double head = (chart_.subtitle.empty() ? 40 : 58) + 0.0;
    std::vector<double> before(columns_, 0), below(rows_, 14);
    for (std::size_t k = 0; k < chart_.panels.size(); ++k) {
      if (!chart_.polar && shows_y(k)) before[k % columns_] = y_axis_space;
      if (chart_.polar || shows_x(k)) below[k / columns_] = x_axis_space;
    }
    for (std::size_t column = 1; column < columns_; ++column) before[column] += panel_gap;
    legend_rows_ = std::max<std::size_t>(entries_.size(), 1);
    const double taken = [&] {
      double sum = 2 * margin;
      for (const double space : before) sum += space;
      return sum;
    }();
    double legend = 0;
    const auto measure_legend = [&](double room) {
      legend_rows_ = std::max<std::size_t>(static_cast<std::size_t>(room / legend_step), 1);
      const std::size_t legend_columns = (entries_.size() + legend_rows_ - 1) / legend_rows_;
      double widest = 0;
      for (const Entry& entry : entries_) widest = std::max(widest, text_width(entry.label, legend_size));
      legend_column_ = mark_width + 8 + widest + 12;
      legend = static_cast<double>(legend_columns) * legend_column_;
      legend = std::max(legend, text_width(chart_.legend_title, legend_size, true));
      for (const auto& note : chart_.notes) legend = std::max(legend, text_width(note, legend_size - 1));
      if (legend > 0) legend += 18;
    };
    // A legend's width hangs on the height of the panels, which are as high as they are wide suits them.
    panel_height_ = chart_.panel_height > 0 ? chart_.panel_height : columns_ == 1 && rows_ == 1 ? 380 : 230;
    const double height = panel_height_ * static_cast<double>(rows_);
    measure_legend(height - 20 - 16 * static_cast<double>(chart_.notes.size()));
    panel_width_ = chart_.panel_width > 0
                       ? chart_.panel_width
                       : std::max((usual_width - taken - legend) / static_cast<double>(columns_), 200.0);
    for (const Panel& panel : chart_.panels)
      panel_width_ = std::max(panel_width_, text_width(panel.title, panel_title_size, true));
    double y = head;
    for (std::size_t row = 0; row < rows_; ++row) {
      if (!chart_.panels[row * columns_].heading.empty()) y += heading_space;
      if (titled) y += panel_title_space;
      double x = margin;
      for (std::size_t column = 0; column < columns_; ++column) {
        x += before[column];
        boxes_.push_back({x, y, x + panel_width_, y + panel_height_});
        x += panel_width_;
      }
      y += panel_height_ + below[row];
      legend_left_ = x + 18;
    }
    width_ = std::ceil(std::max({legend_left_ - 18 + legend + margin,
                                 2 * margin + text_width(chart_.title, title_size, true),
                                 2 * margin + text_width(chart_.subtitle, subtitle_size)}));
    height_ = std::ceil(y + margin / 2);
  }

  Ink ink_of(const std::string& label) const {
    const auto at = std::find_if(entries_.begin(), entries_.end(),
                                 [&](const auto& entry) { return entry.label == label; });
    const auto k = static_cast<std::size_t>(at - entries_.begin());
    if (at == entries_.end()) return inks::text;
    return chart_.colours == Colours::steps ? step_ink(k, entries_.size()) : category_ink(k);
  }

  std::string dash(const std::string& label) const {
    if (chart_.colours == Colours::steps) return "";
    const auto at = std::find_if(entries_.begin(), entries_.end(),
                                 [&](const auto& entry) { return entry.label == label; });
    return dash_of(static_cast<std::size_t>(at - entries_.begin()));
  }

  template <class Frame>
  void draw_in(Svg& svg, const Frame& frame, const Panel& panel, const Box& box, const Shown& shown) const {
    frame.draw(svg, shown);
    frame.clip(svg);
    for (const Rule& rule : panel.rules) {
      const double y = frame.place({panel.x.low, rule.y}).y;
      svg.line(box.left, y, box.right, y, inks::text, 1, "6 4");
    }
    for (const Series& series : panel.series) {
      if (series.dots) {
        svg.begin_group(svg.fill(ink_of(series.label)));
        for (const ChartPoint& point : series.points) {
          const ChartPoint at = frame.place(point);
          if (at.x >= box.left - 1 && at.x <= box.right + 1 && at.y <= box.bottom + 1 && at.y >= box.top - 1)
            svg.dot(at.x, at.y, series.size);
        }
        svg.end_group();
        continue;
      }
      std::string d;
      for (const ChartPoint& point : series.points) {
        const ChartPoint at = frame.place(point);
        d += fmt::format("{}{:.2f} {:.2f}", d.empty() ? "M" : "L", at.x, std::clamp(at.y, -2000.0, 4000.0));
      }
      if (!d.empty())
        svg.path(d, ink_of(series.label), series.size, dash(series.label), "stroke-linejoin=\"round\"");
    }
    svg.end_group();
    for (const Rule& rule : panel.rules)
      svg.text(box.right - 6, frame.place({panel.x.low, rule.y}).y - 5, rule.label,
               {.anchor = "end", .size = 11, .ink = inks::faint_text, .halo = true});
  }

  void draw(Svg& svg, std::size_t k) const {
    const Panel& panel = chart_.panels[k];
    const Box& box = boxes_[k];
    if (!panel.title.empty())
      svg.text(box.left, box.top - 9, panel.title,
               {.anchor = "start", .size = panel_title_size, .bold = true});
    if (!panel.heading.empty())
      svg.text(margin, box.top - 9 - panel_title_space, panel.heading,
               {.anchor = "start", .size = heading_size});
    const Shown shown{chart_.polar || shows_x(k), chart_.polar || shows_y(k)};
    if (chart_.polar)
      draw_in(svg, PolarFrame(box, panel.x, panel.y), panel, box, shown);
    else
      draw_in(svg, RectangularFrame(box, panel.x, panel.y), panel, box, shown);
    if (!panel.note.empty()) svg.text(box.middle_x(), box.middle_y(), panel.note, {.ink = inks::faint_text});
  }

  void draw_legend(Svg& svg) const {
    if (entries_.empty()) return;
    double y = boxes_.front().top + 10;
    if (!chart_.legend_title.empty()) {
      svg.text(legend_left_, y, chart_.legend_title, {.anchor = "start", .size = legend_size, .bold = true});
      y += legend_step + 2;
    }
    for (std::size_t k = 0; k < entries_.size(); ++k) {
      const double x = legend_left_ + legend_column_ * static_cast<double>(k / legend_rows_);
      const double at = y + legend_step * static_cast<double>(k % legend_rows_);
      const Ink ink = ink_of(entries_[k].label);
      if (entries_[k].line) svg.line(x, at - 4, x + mark_width, at - 4, ink, 2.2, dash(entries_[k].label));
      if (entries_[k].dots) svg.disc(x + 0.5 * mark_width, at - 4, 2.6, ink);
      svg.text(x + mark_width + 8, at, entries_[k].label, {.anchor = "start", .size = legend_size});
    }
    y += legend_step * static_cast<double>(std::min(legend_rows_, entries_.size())) + 4;
    for (const auto& note : chart_.notes) {
      svg.text(legend_left_, y, note, {.anchor = "start", .size = legend_size - 1, .ink = inks::faint_text});
      y += 16;
    }
  }

  static std::string json(const std::string& text) {
    return nlohmann::json(plain_text(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  }

  static std::string axis_data(const ChartAxis& axis, double from, double to) {
    return fmt::format(
        R"({{"label":{},"low":{:.9g},"high":{:.9g},"logarithmic":{},"from":{:.2f},"to":{:.2f}}})",
        json(axis.label), axis.low, axis.high, axis.logarithmic, from, to);
  }

  std::string data() const {
    std::string text = fmt::format(R"({{"title":{},"polar":{},"panels":[)", json(chart_.title), chart_.polar);
    for (std::size_t k = 0; k < chart_.panels.size(); ++k) {
      const Panel& panel = chart_.panels[k];
      const Box& box = boxes_[k];
      text += fmt::format(R"({}{{"title":{},"x":{},"y":{},"series":[)", k ? "," : "", json(panel.title),
                          axis_data(panel.x, box.left, box.right), axis_data(panel.y, box.bottom, box.top));
      for (std::size_t j = 0; j < panel.series.size(); ++j) {
        const Series& series = panel.series[j];
        std::string x, y;
        for (const ChartPoint& point : series.points) {
          x += fmt::format("{}{:.9g}", x.empty() ? "" : ",", point.x);
          y += fmt::format("{}{:.9g}", y.empty() ? "" : ",", point.y);
        }
        text += fmt::format(R"({}{{"label":{},"marks":"{}","x":[{}],"y":[{}]}})", j ? "," : "",
                            json(series.label), series.dots ? "dots" : "line", x, y);
      }
      text += "]}";
    }
    return text + "]}";
  }

  const Chart& chart_;
  std::vector<Entry> entries_;
  std::size_t columns_ = 1, rows_ = 1;
  std::vector<Box> boxes_;
  double panel_width_ = 0, panel_height_ = 0;
  double legend_left_ = 0, legend_column_ = 0;
  std::size_t legend_rows_ = 1;
  double width_ = 0, height_ = 0;
};

}  // namespace

std::string Chart::svg() const { return Drawing(*this).svg(); }

}  // namespace brdftab

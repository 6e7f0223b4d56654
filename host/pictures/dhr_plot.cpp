// Directional-hemispherical reflectance against the angle of incidence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/compute/integrals.hpp"
#include "host/pictures/drawing/chart.hpp"
#include "host/pictures/drawing/smooth_curve.hpp"
#include "host/pictures/plot.hpp"

namespace brdftab {
namespace {

// Above this, the line at 1 stands on a linear axis; below, it would press curves to the bottom.
constexpr double bright = 0.4;
constexpr double most_decades = 5;
constexpr double node_radius = 2.2;

// Every degree, and where R has a kink: at the Brewster angle and, for n_eff < 1, at the critical one.
std::vector<double> incidences(const Parameters& p) {
  std::vector<double> kinks{std::atan(p.n_eff) * 180 / std::numbers::pi, 89.5};
  if (p.n_eff < 1) kinks.push_back(std::asin(p.n_eff) * 180 / std::numbers::pi);
  return curve_starts(0, 89.9, 1, kinks);
}

std::vector<ChartPoint> stored(const Subject& subject, std::string_view name, std::size_t band) {
  std::vector<ChartPoint> points;
  const auto nodes = subject.table().grid.theta_i.nodes();
  const auto& values = subject.reader().info().variable(name)->values;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    points.push_back({nodes[k], values[band * nodes.size() + k]});
  return points;
}

}  // namespace

std::string dhr_plot(std::span<const Subject> subjects, const PlotOptions& options,
                     const LazyEngine& engine) {
  Chart chart{.title = picture_title(subjects, "directional-hemispherical reflectance"),
              .subtitle = light_text(subjects[0], options, std::nullopt),
              .legend_title = "lobe",
              .notes = {},
              .columns = 3,
              .panel_width = 220,
              .panel_height = 300,
              .panels = {}};
  const auto labels = subject_labels(subjects);
  double largest = 0, smallest = 1;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const Subject& subject = subjects[s];
    const std::size_t index = subject.band(options.wavelength_nm);
    const Band& band = subject.material().bands()[index];
    const auto theta_i = incidences(band.parameters);
    const Dhr dhr = integrals(engine(), band, subject.material().variant(), theta_i).dhr;
    for (const auto& [name, polarization] : {std::pair{"unpolarised", Polarization::unpolarized},
                                             {"s-polarised", Polarization::s},
                                             {"p-polarised", Polarization::p}}) {
      Panel panel{.title = name,
                  .x = {"incidence θ_i (degrees)", 0, 90, false, 30},
                  .y = {},
                  .series = {},
                  .rules = {{1, "DHR = 1"}}};
      std::vector<ChartPoint> total;
      for (std::size_t k = 0; k < theta_i.size(); ++k) {
        total.push_back({theta_i[k], dhr.total(k, polarization)});
        largest = std::max(largest, total.back().y);
      }
      panel.line("all", std::move(total));
      panel.series.back().size = 2.4;
      for (std::size_t lobe = 0; lobe < 3; ++lobe) {
        std::vector<ChartPoint> points;
        for (std::size_t k = 0; k < theta_i.size(); ++k) {
          points.push_back({theta_i[k], dhr.lobe(lobe, k, polarization)});
          if (points.back().y > 0) smallest = std::min(smallest, points.back().y);
        }
        panel.line(std::string(lobe_names[lobe]), std::move(points));
      }
      if (subject.is_table() && polarization == Polarization::unpolarized) {
        panel.dots("all", stored(subject, "dhr", index), node_radius);
        for (const std::string_view lobe : lobe_names)
          panel.dots(std::string(lobe), stored(subject, fmt::format("dhr_{}", lobe), index), node_radius);
        chart.notes = {"curves: the model", "dots: in the table"};
      }
      if (subjects.size() > 1 && polarization == Polarization::unpolarized) panel.heading = labels[s];
      chart.panels.push_back(std::move(panel));
    }
  }
  const bool linear = largest > bright;
  const ChartAxis y = linear ? ChartAxis{"DHR", 0, std::max(1.1, 1.05 * largest)}
                             : logarithmic_axis("DHR", smallest, 1.2, most_decades);
  for (Panel& panel : chart.panels) panel.y = y;
  return chart.svg();
}

}  // namespace brdftab

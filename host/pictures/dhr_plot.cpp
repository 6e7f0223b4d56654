// Directional-hemispherical reflectance against the angle of incidence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"
#include "host/compute/integrals.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/pictures/drawing/chart.hpp"
#include "host/pictures/drawing/smooth_curve.hpp"
#include "host/pictures/plot.hpp"

namespace brdftab {
namespace {

// Where DHR exceeds this, the axis is linear up to the line at 1. That axis would press smaller values to its
// bottom, so they get a logarithmic one.
constexpr double bright = 0.4;
constexpr double most_decades = 5;
constexpr double node_radius = 2.2;

// The curves begin with every degree and with the angles where R has a kink: the Brewster angle and, for
// n_eff < 1, the critical angle.
std::vector<double> incidences(const Parameters& p) {
  std::vector<double> kinks{degrees(std::atan(p.n_eff)), 89.5};
  if (p.n_eff < 1) kinks.push_back(degrees(std::asin(p.n_eff)));
  return drawing::curve_starts(0, 89.9, 1, kinks);
}

// What a table holds under a name, against theta_i.
std::vector<drawing::ChartPoint> stored(const Subject& subject, std::string_view name, std::size_t band) {
  std::vector<drawing::ChartPoint> points;
  const auto nodes = subject.table().grid.theta_i.nodes();
  const auto& values = subject.reader().info().variable(name)->values;
  for (std::size_t k = 0; k < nodes.size(); ++k)
    points.push_back({nodes[k], values[band * nodes.size() + k]});
  return points;
}

// The largest DHR of all lobes together, and the smallest of one lobe that is not 0.
struct Extremes {
  double largest = 0;
  double smallest = 1;
};

drawing::Panel panel_for(Polarization polarization, const std::vector<double>& theta_i, const Dhr& dhr,
                         Extremes& extremes) {
  drawing::Panel panel{.title = std::string(light_word(share_s(polarization))),
                       .x = {"incidence θ_i (degrees)", 0, 90, false, 30},
                       .y = {},
                       .series = {},
                       .rules = {{1, "DHR = 1"}}};
  std::vector<drawing::ChartPoint> total;
  for (std::size_t k = 0; k < theta_i.size(); ++k) {
    total.push_back({theta_i[k], dhr.total(k, polarization)});
    extremes.largest = std::max(extremes.largest, total.back().y);
  }
  panel.line("all", std::move(total));
  panel.series.back().size = 2.4;
  for (std::size_t lobe = 0; lobe < lobe_names.size(); ++lobe) {
    std::vector<drawing::ChartPoint> points;
    for (std::size_t k = 0; k < theta_i.size(); ++k) {
      points.push_back({theta_i[k], dhr.lobe(lobe, k, polarization)});
      if (points.back().y > 0) extremes.smallest = std::min(extremes.smallest, points.back().y);
    }
    panel.line(std::string(lobe_names[lobe]), std::move(points));
  }
  return panel;
}

// The values that a table stores; they are for unpolarised light.
void add_stored(drawing::Panel& panel, const Subject& subject, std::size_t band) {
  panel.dots("all", stored(subject, "dhr", band), node_radius);
  for (const std::string_view lobe : lobe_names)
    panel.dots(std::string(lobe), stored(subject, fmt::format("dhr_{}", lobe), band), node_radius);
}

}  // namespace

std::string dhr_plot(std::span<const Subject> subjects, const PlotOptions& options,
                     const LazyEngine& engine) {
  drawing::Chart chart{.title = picture_title(subjects, "directional-hemispherical reflectance"),
                       .subtitle = light_text(subjects[0], options, std::nullopt),
                       .legend_title = "lobe",
                       .notes = {},
                       .columns = 3,
                       .panel_width = 220,
                       .panel_height = 300,
                       .panels = {}};
  const auto labels = subject_labels(subjects);
  Extremes extremes;
  for (std::size_t s = 0; s < subjects.size(); ++s) {
    const Subject& subject = subjects[s];
    const std::size_t index = subject.band(options.wavelength_nm);
    const Band& band = subject.material().bands()[index];
    const auto theta_i = incidences(band.parameters);
    const Dhr dhr = integrals(engine(), band, subject.material().variant(), theta_i).dhr;
    for (const Polarization polarization : {Polarization::unpolarized, Polarization::s, Polarization::p}) {
      drawing::Panel panel = panel_for(polarization, theta_i, dhr, extremes);
      if (polarization == Polarization::unpolarized) {
        if (subject.is_table()) {
          add_stored(panel, subject, index);
          chart.notes = {"curves: the model", "dots: in the table"};
        }
        if (subjects.size() > 1) panel.heading = labels[s];
      }
      chart.panels.push_back(std::move(panel));
    }
  }
  const drawing::ChartAxis y = extremes.largest > bright
                                   ? drawing::ChartAxis{"DHR", 0, std::max(1.1, 1.05 * extremes.largest)}
                                   : drawing::logarithmic_axis("DHR", extremes.smallest, 1.2, most_decades);
  for (drawing::Panel& panel : chart.panels) panel.y = y;
  return chart.svg();
}

}  // namespace brdftab

// Curves of f in the plane of incidence.
#include <algorithm>
#include <cmath>
#include <vector>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/pictures/drawing/smooth_curve.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/plot.hpp"
#include "host/pictures/table_slice.hpp"

namespace brdftab {
namespace {

constexpr double node_radius = 1.3;
constexpr double same_incidence = 0.01;  // degrees; a measured sample this close belongs to a curve
constexpr std::size_t most_measured = 9;
// The axis of lobes goes down so many decades below the weakest total: what is weaker does not matter to f.
constexpr double lobe_decades = 2;

// Beyond this theta_s, shadowing may bring f close to 0: the axis does not follow it there.
constexpr double farthest_low = 80;  // degrees

using Scans = std::vector<InPlaneScan>;

std::vector<double> incidences(const Subject& subject, const PlotOptions& options, const Scans& measured) {
  if (options.theta_i) {
    if (subject.is_table()) subject.nodes_theta_i(*options.theta_i);
    return *options.theta_i;
  }
  if (measured.empty() || subject.is_table()) return subject.usual_theta_i(usual_incidences);
  std::vector<double> angles;
  for (const std::size_t k : spread_indices(measured.size(), most_measured))
    angles.push_back(measured[k].theta_i);
  return angles;
}

// The points of the scan that is nearest to theta_i; none where it is further than half the width
// of a setting.
std::vector<drawing::ChartPoint> at_incidence(const Scans& measured, double theta_i, double width) {
  const auto distance = [&](const InPlaneScan& scan) { return std::abs(scan.theta_i - theta_i); };
  const auto nearest = std::min_element(measured.begin(), measured.end(), [&](const auto& a, const auto& b) {
    return distance(a) < distance(b);
  });
  if (nearest == measured.end() || distance(*nearest) > std::max(same_incidence, 0.5 * width)) return {};
  return nearest->points;
}

drawing::ChartAxis axis_around(const std::vector<drawing::Panel>& panels) {
  double low = HUGE_VAL, high = 0;
  for (const drawing::Panel& panel : panels)
    for (const drawing::Series& series : panel.series)
      for (const drawing::ChartPoint& point : series.points) {
        high = std::max(high, point.y);
        if (point.y > 0 && std::abs(point.x) <= farthest_low) low = std::min(low, point.y);
      }
  return drawing::logarithmic_axis(brdf_axis_label, low, high);
}

// A chart without panels yet, whose colours stand for angles of incidence.
drawing::Chart chart_by_incidence(std::string_view title, std::span<const Subject> subjects,
                                  const PlotOptions& options, Polarization polarization) {
  return {.title = picture_title(subjects, title),
          .subtitle = light_text(subjects[0], options, polarization),
          .legend_title = "incidence θ_i",
          .notes = {},
          .colours = drawing::Colours::steps,
          .columns = 2,
          .panels = {}};
}

drawing::Chart in_plane_chart(std::span<const Subject> subjects, const PlotOptions& options,
                              const LazyEngine& engine) {
  const Polarization polarization = drawn_polarization(subjects, options);
  const Scans measured =
      options.data ? in_plane_scans(options.data->samples, options.data->incidences()) : Scans{};
  if (options.data && measured.empty())
    throw BadInput("{}: no sample lies in the plane of incidence", options.data->source);
  drawing::Chart chart =
      chart_by_incidence("BRDF in the plane of incidence", subjects, options, polarization);
  const auto labels = subject_labels(subjects);
  bool any_table = false;
  std::size_t shown = 0;  // counts the scans that are drawn
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const Subject& subject = subjects[k];
    const std::size_t band = subject.band(options.wavelength_nm);
    const auto theta_i = incidences(subject, options, measured);
    const DrawnModel model(engine(), subject, band, polarization);
    drawing::Panel panel{.title = subjects.size() > 1 ? labels[k] : "",
                         .x = subjects.size() > 1 ? narrow_theta_s_axis() : theta_s_axis(),
                         .y = {}};
    const auto curves =
        in_plane_curves(theta_i, [&](std::span<const DirectionPair> pairs) { return model.brdf(pairs); });
    for (std::size_t i = 0; i < theta_i.size(); ++i) panel.line(incidence_label(theta_i[i]), curves[i]);
    for (std::size_t i = 0; i < theta_i.size(); ++i) {
      if (subject.is_table() && measured.empty()) {
        const auto node = subject.nodes_theta_i({&theta_i[i], 1})[0];
        panel.dots(incidence_label(theta_i[i]),
                   TableSlice::read(subject, node, band, polarization).in_plane(), node_radius);
        any_table = true;
      }
      if (auto points = at_incidence(measured, theta_i[i], options.data ? options.data->incidence_width : 0);
          !points.empty()) {
        panel.dots(incidence_label(theta_i[i]), std::move(points));
        ++shown;
      }
    }
    chart.panels.push_back(std::move(panel));
  }
  if (any_table) chart.notes = {"curves: the model", "dots: nodes of the table"};
  if (!measured.empty()) {
    chart.notes = {"curves: the model", "dots: measured"};
    if (const std::string note = not_drawn_note(options.data->samples); !note.empty())
      chart.notes.push_back(note);
    if (shown < measured.size())
      chart.notes.push_back(fmt::format("at {} of {} θ_i", shown, measured.size()));
  }
  const drawing::ChartAxis y = axis_around(chart.panels);
  for (drawing::Panel& panel : chart.panels) panel.y = y;
  return chart;
}

}  // namespace

std::string in_plane_plot(std::span<const Subject> subjects, const PlotOptions& options,
                          const LazyEngine& engine) {
  return in_plane_chart(subjects, options, engine).svg();
}

std::string polar_plot(std::span<const Subject> subjects, const PlotOptions& options,
                       const LazyEngine& engine) {
  drawing::Chart chart = in_plane_chart(subjects, options, engine);
  chart.polar = true;
  chart.columns = 1;
  chart.panel_height = 300;
  chart.subtitle += "; the angle is θ_s, forward side to the right, the radius log f";
  return chart.svg();
}

std::string lobes_plot(std::span<const Subject> subjects, const PlotOptions& options,
                       const LazyEngine& engine) {
  const Polarization polarization = drawn_polarization(subjects, options);
  drawing::Chart chart =
      chart_by_incidence("BRDF in the plane of incidence, by lobe", subjects, options, polarization);
  const auto labels = subject_labels(subjects);
  std::vector<drawing::Panel> totals;
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const DrawnModel model(engine(), subjects[k], subjects[k].band(options.wavelength_nm), polarization);
    const auto theta_i = incidences(subjects[k], options, {});
    const auto add = [&](std::string_view name, const auto& values) {
      drawing::Panel panel{.title = std::string(name), .x = narrow_theta_s_axis(), .y = {}};
      const auto curves = in_plane_curves(theta_i, values);
      bool scatters = false;
      for (std::size_t i = 0; i < theta_i.size(); ++i) {
        scatters |= std::any_of(curves[i].begin(), curves[i].end(),
                                [](const drawing::ChartPoint& point) { return point.y > 0; });
        panel.line(incidence_label(theta_i[i]), curves[i]);
      }
      if (!scatters) {
        panel.series.clear();
        panel.note = "scatters nothing";
      }
      chart.panels.push_back(std::move(panel));
    };
    add("all lobes", [&](std::span<const DirectionPair> pairs) { return model.brdf(pairs); });
    if (subjects.size() > 1) chart.panels.back().heading = labels[k];
    totals.push_back(chart.panels.back());
    for (std::size_t lobe = 0; lobe < lobe_names.size(); ++lobe)
      add(fmt::format("{} lobe", lobe_names[lobe]),
          [&](std::span<const DirectionPair> pairs) { return model.brdf(static_cast<Lobe>(lobe), pairs); });
  }
  const drawing::ChartAxis around = axis_around(totals);
  const drawing::ChartAxis y = drawing::logarithmic_axis(
      around.label, around.low * std::pow(10, -lobe_decades), around.high / 1.06, 9);
  for (drawing::Panel& panel : chart.panels) {
    panel.y = y;
    const bool seen =
        std::any_of(panel.series.begin(), panel.series.end(), [&](const drawing::Series& series) {
          return std::any_of(series.points.begin(), series.points.end(),
                             [&](const drawing::ChartPoint& p) { return p.y > y.low; });
        });
    if (!panel.series.empty() && !seen) panel.note = "below the axis";
  }
  return chart.svg();
}

}  // namespace brdftab

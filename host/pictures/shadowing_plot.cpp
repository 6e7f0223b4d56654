// V_m of Eq. (13) and V of Eq. (10); the scalar reference computes both.
#include "host/pictures/shadowing_plot.hpp"

#include <cmath>

#include "host/pictures/drawing/smooth_curve.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/plot.hpp"
#include "host/reference/reflectance_shadowing.hpp"
#include "host/reference/width_shadowing.hpp"

namespace brdftab {
namespace {

constexpr double shown_incidences[] = {30, 70};  // degrees

}  // namespace

drawing::Panel reflectance_shadowing_panel(const Parameters& p, std::span<const double> theta_i) {
  const reference::ReflectanceShadowingParameters parameters{p.w_a, p.w_b, p.gamma, p.delta};
  drawing::Panel panel{.title = "V_m on the reflectance, Eq. (13)",
                       .x = narrow_theta_s_axis(),
                       .y = {"V_m", 0, 1.05, false, 0.2}};
  const double plane[] = {0};
  const auto curves = drawing::smooth_curves(
      std::vector(theta_i.size(), drawing::curve_starts(-89.99, 89.99, 1, plane)),
      [&](std::span<const drawing::CurvePlace> places) {
        std::vector<double> values;
        for (const drawing::CurvePlace& place : places)
          values.push_back(static_cast<double>(reference::reflectance_shadowing(
              parameters, reference::Direction::from_degrees(theta_i[place.curve]),
              reference::Direction::from_degrees(std::abs(place.x)), place.x < 0 ? 180 : 0)));
        return values;
      },
      false);
  for (std::size_t k = 0; k < theta_i.size(); ++k) panel.line(incidence_label(theta_i[k]), curves[k]);
  return panel;
}

std::string shadowing_plot(std::span<const Subject> subjects, const PlotOptions& options, const LazyEngine&) {
  drawing::Chart chart{.title = picture_title(subjects, "masking and shadowing"),
                       .subtitle = light_text(subjects[0], options, std::nullopt),
                       .legend_title = "incidence θ_i",
                       .notes = {},
                       .colours = drawing::Colours::steps,
                       .columns = 2,
                       .panel_width = 300,
                       .panel_height = 260,
                       .panels = {}};
  const auto labels = subject_labels(subjects);
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const Subject& subject = subjects[k];
    const Parameters& p = subject.material().bands()[subject.band(options.wavelength_nm)].parameters;
    const Variant& variant = subject.material().variant();
    const std::vector<double> theta_i =
        options.theta_i ? *options.theta_i
                        : std::vector<double>(std::begin(shown_incidences), std::end(shown_incidences));
    chart.panels.push_back(reflectance_shadowing_panel(p, theta_i));
    if (subjects.size() > 1) chart.panels.back().heading = labels[k];
    if (variant.reflectance_shadowing == ReflectanceShadowing::none) {
      chart.panels.back().series.clear();
      chart.panels.back().note = "switched off: V_m = 1";
    }
    drawing::Panel width{.title = "V on the lobes' width, Eq. (10)",
                         .x = {"χ = sin θ_i or sin θ_s", 0, 1, false, 0},
                         .y = {"V(χ)", 0, 1.05, false, 0.2}};
    if (variant.width_shadowing)
      width.line("", drawing::smooth_curves(
                         {drawing::curve_starts(0, 1, 0.01, {})},
                         [&](std::span<const drawing::CurvePlace> places) {
                           std::vector<double> values;
                           for (const drawing::CurvePlace& place : places)
                             values.push_back(static_cast<double>(
                                 reference::width_shadowing(place.x * place.x, p.w, p.n)));
                           return values;
                         },
                         false)[0]);
    else
      width.note = "switched off: V = 1";
    chart.panels.push_back(std::move(width));
  }
  return chart.svg();
}

}  // namespace brdftab

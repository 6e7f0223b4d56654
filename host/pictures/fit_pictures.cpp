#include "host/pictures/fit_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/slab.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/pictures/drawing/matrix_figure.hpp"
#include "host/pictures/drawing/picture_file.hpp"
#include "host/pictures/drawing/svg.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/shadowing_plot.hpp"

namespace brdftab {
namespace {

constexpr std::array<double, 2> shown_shadowing{30, 70};
// A legend holds so many entries in one column above three notes.
constexpr std::size_t most_incidences = 17;

void write(const std::filesystem::path& path, const std::string& text, bool force) {
  drawing::PictureFile(path, 0, force).write(text);
}

// The curves and the measured points for the samples in one light. Notes about them are added to the chart.
drawing::Panel fit_panel(const Engine& engine, const FitProblem& problem,
                         std::span<const MeasuredSample> samples, const Parameters& parameters,
                         drawing::Chart& chart) {
  const std::vector<InPlaneScan> scans = in_plane_scans(samples, problem.incidences());
  std::vector<InPlaneScan> drawn;
  for (const std::size_t k : spread_indices(scans.size(), most_incidences)) drawn.push_back(scans[k]);
  drawing::Panel panel{.title = "", .x = theta_s_axis(), .y = {}};
  if (drawn.empty()) panel.note = "no sample lies in the plane of incidence";
  if (drawn.size() < scans.size())
    chart.notes.push_back(fmt::format("at {} of {} θ_i", drawn.size(), scans.size()));
  if (const std::string note = not_drawn_note(samples); !note.empty()) chart.notes.push_back(note);
  if (drawn.empty()) return panel;
  std::vector<double> theta_i;
  for (const InPlaneScan& scan : drawn) theta_i.push_back(scan.theta_i);
  const double share_s = samples.front().share_s;
  const auto curves = in_plane_curves(theta_i, [&](std::span<const DirectionPair> pairs) {
    const LogBrdfGradients model(engine, pairs, share_s, problem.options().variant);
    const auto values = model.evaluate({&parameters, 1});
    std::vector<double> f;
    for (std::size_t k = 0; k < pairs.size(); ++k) f.push_back(std::exp(values.ln_f(0)[k]));
    return f;
  });
  for (std::size_t k = 0; k < drawn.size(); ++k) {
    panel.line(incidence_label(theta_i[k]), curves[k]);
    panel.dots(incidence_label(theta_i[k]), drawn[k].points);
  }
  return panel;
}

std::string fit_picture(const Engine& engine, const FitProblem& problem, const FitBand& band,
                        const Parameters& parameters) {
  std::map<double, std::vector<MeasuredSample>, std::greater<>>
      lights;  // keyed by the share of s-polarised light
  for (const MeasuredSample& sample : band.samples) lights[sample.share_s].push_back(sample);
  drawing::Chart chart{.title = "BRDF in the plane of incidence: measured and fitted",
                       .subtitle = "",
                       .legend_title = "incidence θ_i",
                       .notes = {"curves: fitted", "dots: measured"},
                       .colours = drawing::Colours::steps,
                       .columns = lights.size(),
                       .panels = {}};
  double low = HUGE_VAL;
  double high = 0;
  for (const auto& [share_s, samples] : lights) {
    drawing::Panel panel = fit_panel(engine, problem, samples, parameters, chart);
    if (lights.size() > 1) {
      panel.title = light_word(share_s);
      panel.x = narrow_theta_s_axis();
    }
    for (const drawing::Series& series : panel.series)
      for (const drawing::ChartPoint& point : series.points) {
        if (!series.dots) continue;
        low = std::min(low, point.y);
        high = std::max(high, point.y);
      }
    chart.panels.push_back(std::move(panel));
  }
  for (drawing::Panel& panel : chart.panels)
    panel.y = drawing::logarithmic_axis(brdf_axis_label, low / 1.5, high * 1.5);
  return chart.svg();
}

std::string residual_picture(const FitProblem& problem, const FitBand& band,
                             const std::vector<double>& misfits) {
  const Incidences& settings = problem.incidences();
  double largest = 1e-6;
  for (const double misfit : misfits) largest = std::max(largest, std::abs(misfit));
  drawing::Chart chart{.title = "Residuals of the fit",
                       .subtitle = "θ_s is negative over the whole backward half-space",
                       .legend_title = "incidence θ_i",
                       .notes = {},
                       .colours = drawing::Colours::steps,
                       .panels = {}};
  drawing::Panel panel{.title = "",
                       .x = theta_s_axis(),
                       .y = {problem.options().take_sigma() ? "(model − data) / σ" : "ln(model / data)",
                             -1.1 * largest, 1.1 * largest}};
  panel.rules.push_back({0, ""});
  const Incidences told_apart = settings.joined(most_incidences);
  std::vector<std::vector<drawing::ChartPoint>> points(told_apart.size());
  for (std::size_t k = 0; k < misfits.size(); ++k) {
    const auto& pair = band.samples[k].pair;
    const bool backward = std::cos(radians(pair.model_phi())) < 0;
    points[told_apart.index(pair.theta_i)].push_back(
        {backward ? -pair.model_theta_s() : pair.model_theta_s(), misfits[k]});
  }
  for (std::size_t k = 0; k < points.size(); ++k) {
    const double first = settings.angle(settings.index(told_apart.lowest(k)));
    const double last = settings.angle(settings.index(told_apart.highest(k)));
    if (!points[k].empty()) panel.dots(incidence_label(first, last), std::move(points[k]));
  }
  chart.panels.push_back(std::move(panel));
  return chart.svg();
}

std::string shadowing_picture(const Parameters& parameters) {
  drawing::Chart chart{.title = "Masking and shadowing of the reflectance",
                       .subtitle = "",
                       .legend_title = "incidence θ_i",
                       .notes = {},
                       .colours = drawing::Colours::steps,
                       .panels = {}};
  chart.panels.push_back(reflectance_shadowing_panel(parameters, shown_shadowing));
  return chart.svg();
}

// What a fitted variable is called in a file, with the symbol of the parameter in place of its name.
std::string shown_name(const std::string& name) {
  for (const auto& row : parameter_table)
    if (name.starts_with(row.name) && (name.size() == row.name.size() || name[row.name.size()] == ' '))
      return drawing::subscripted(row.symbol) + drawing::literal(name.substr(row.name.size()));
  return drawing::literal(name);
}

std::string correlation_picture(const FitSummary& summary) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  const Eigen::MatrixXd& covariance = summary.linear.covariance;
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    names.push_back(shown_name(summary.variables[summary.linear.active[static_cast<std::size_t>(i)]].name));
    values.emplace_back();
    for (Eigen::Index j = 0; j < covariance.rows(); ++j)
      values.back().push_back(covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)));
  }
  return drawing::matrix_figure("Correlations of the fitted parameters", names, values);
}

}  // namespace

void write_fit_pictures(const Engine& engine, const FitProblem& problem, const FitSummary& summary,
                        const std::filesystem::path& folder, bool force) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw FileError("{}: cannot be made: {}", folder.string(), error.message());
  const auto evaluated = problem.batch().evaluate(summary.bands);
  for (std::size_t b = 0; b < problem.bands().size(); ++b) {
    const FitBand& band = problem.bands()[b];
    const std::string suffix = problem.bands().size() > 1 && band.wavelength_nm
                                   ? fmt::format("-{}", shortest(*band.wavelength_nm))
                                   : "";
    write(folder / fmt::format("fit{}.svg", suffix), fit_picture(engine, problem, band, summary.bands[b]),
          force);
    write(folder / fmt::format("residuals{}.svg", suffix),
          residual_picture(problem, band, problem.misfits(evaluated[b], b)), force);
    write(folder / fmt::format("shadowing{}.svg", suffix), shadowing_picture(summary.bands[b]), force);
  }
  write(folder / "correlations.svg", correlation_picture(summary), force);
}

}  // namespace brdftab

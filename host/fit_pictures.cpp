#include "host/fit_pictures.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <optional>

#include "host/error.hpp"
#include "host/numbers.hpp"
#include "host/partial_file.hpp"
#include "host/reference/reflectance_shadowing.hpp"
#include "host/svg_chart.hpp"

namespace brdftab {
namespace {

// Samples this near to the plane of incidence, in degrees of azimuth, count as in plane.
constexpr double in_plane = 3;
constexpr std::array<double, 2> shown_shadowing{30, 70};

using reference::Direction;

void write(const std::filesystem::path& path, const std::string& text, bool force) {
  PartialFile file(path, force);
  std::ofstream out(file.path(), std::ios::binary);
  out << text;
  out.close();
  if (!out) throw FileError("{}: cannot be written: {}", path.string(), std::generic_category().message(errno));
  file.commit();
}

// theta_s with the sign of the side, where a sample is in plane.
std::optional<double> signed_theta_s(const DirectionPair& pair) {
  const double phi = std::remainder(pair.model_phi(), 360);
  if (pair.model_theta_s() == 0 || std::abs(phi) <= in_plane) return pair.model_theta_s();
  if (180 - std::abs(phi) <= in_plane) return -pair.model_theta_s();
  return std::nullopt;
}

std::string incidence_label(double theta_i) { return fmt::format("theta_i = {}°", shortest(theta_i)); }

std::string fit_picture(const Engine& engine, const FitProblem& problem, const FitBand& band, const Parameters& parameters) {
  std::map<double, std::vector<ChartPoint>> data;
  double low = HUGE_VAL;
  double high = 0;
  for (const auto& sample : band.samples)
    if (const auto theta_s = signed_theta_s(sample.pair)) {
      data[sample.pair.theta_i].push_back({*theta_s, sample.brdf});
      low = std::min(low, sample.brdf);
      high = std::max(high, sample.brdf);
    }
  if (data.empty()) low = 0.1, high = 1;
  SvgChart chart("f in the plane of incidence: measured (dots), fitted (lines)", {"theta_s, degrees (forward positive)", -90, 90},
                 {"f, 1/sr", low / 2, high * 2, true});
  std::vector<DirectionPair> pairs;
  for (const auto& [theta_i, points] : data)
    for (double theta_s = -85; theta_s <= 85; theta_s += 0.5) pairs.push_back({theta_i, theta_s, 0, 0});
  if (!pairs.empty()) {
    const LogBrdfGradients model(engine, pairs, problem.options().share_s, problem.options().switches);
    const auto values = model.evaluate({&parameters, 1});
    std::size_t k = 0;
    for (const auto& [theta_i, points] : data) {
      std::vector<ChartPoint> curve;
      for (; k < pairs.size() && pairs[k].theta_i == theta_i; ++k)
        curve.push_back({pairs[k].theta_s, std::exp(values.ln_f(0)[k])});
      chart.line(incidence_label(theta_i), curve);
      chart.dots(incidence_label(theta_i), points);
    }
  }
  return chart.text();
}

std::string residual_picture(const FitBand& band, const std::vector<double>& ratios) {
  double largest = 1e-6;
  for (const double ratio : ratios) largest = std::max(largest, std::abs(ratio));
  SvgChart chart("ln(model/data)", {"theta_s, degrees (backward half-space negative)", -90, 90},
                 {"ln(model/data)", -1.1 * largest, 1.1 * largest});
  std::map<double, std::vector<ChartPoint>> points;
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const auto& pair = band.samples[k].pair;
    const bool backward = std::cos(pair.model_phi() * std::numbers::pi / 180) < 0;
    points[pair.theta_i].push_back({backward ? -pair.model_theta_s() : pair.model_theta_s(), ratios[k]});
  }
  for (const auto& [theta_i, at] : points) chart.dots(incidence_label(theta_i), at);
  return chart.text();
}

std::string shadowing_picture(const Parameters& p) {
  SvgChart chart("V_m, Eq. (13)", {"theta_s, degrees (forward positive)", -90, 90}, {"V_m", 0, 1.05});
  for (const double theta_i : shown_shadowing) {
    std::vector<ChartPoint> curve;
    for (double theta_s = -89; theta_s <= 89; theta_s += 0.5)
      curve.push_back({theta_s, static_cast<double>(reference::reflectance_shadowing(
                                    {p.w_a, p.w_b, p.gamma, p.delta}, Direction::from_degrees(theta_i),
                                    Direction::from_degrees(std::abs(theta_s)), theta_s < 0 ? 180 : 0))});
    chart.line(incidence_label(theta_i), curve);
  }
  return chart.text();
}

std::string correlation_picture(const FitSummary& summary) {
  std::vector<std::string> names;
  std::vector<std::vector<double>> values;
  const Eigen::MatrixXd& covariance = summary.linear.covariance;
  for (Eigen::Index i = 0; i < covariance.rows(); ++i) {
    names.push_back(summary.variables[summary.linear.active[static_cast<std::size_t>(i)]].name);
    values.emplace_back();
    for (Eigen::Index j = 0; j < covariance.rows(); ++j)
      values.back().push_back(covariance(i, j) / std::sqrt(covariance(i, i) * covariance(j, j)));
  }
  return svg_matrix("correlations of the fitted parameters", names, values);
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
    const std::string suffix =
        problem.bands().size() > 1 && band.wavelength_nm ? fmt::format("-{}", shortest(*band.wavelength_nm)) : "";
    write(folder / fmt::format("fit{}.svg", suffix), fit_picture(engine, problem, band, summary.bands[b]), force);
    write(folder / fmt::format("residuals{}.svg", suffix), residual_picture(band, problem.log_ratios(evaluated[b], b)), force);
    write(folder / fmt::format("shadowing{}.svg", suffix), shadowing_picture(summary.bands[b]), force);
  }
  write(folder / "correlations.svg", correlation_picture(summary), force);
}

}  // namespace brdftab

// Two tables or materials: the ratio of f over the hemisphere, and where it is furthest from 1.
#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/pictures/hemisphere_figure.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/plot.hpp"
#include "host/pictures/table_slice.hpp"

namespace brdftab {
namespace {

constexpr double shown_incidences[] = {0, 30, 60, 80};
constexpr double same_angle = 1e-9;
constexpr double largest_ratio_drawn = 100;
// Where all ratios are closer than this to 1, the ratio minus 1 is drawn.
constexpr double nearly_one = 1.2;
// Beyond this theta_s, shadowing may bring f so close to 0 that the ratio of two models means nothing.
constexpr double farthest_compared = 85;  // degrees
constexpr double least_difference_drawn = 1e-9;

using Nodes = std::vector<double>;

// One of the two that are compared.
struct Side {
  const Subject& subject;
  std::size_t band;
  Polarization polarization;
  std::optional<DrawnModel> model;  // a table has none: its samples are compared

  // f in 1/sr, as [theta_s][phi]. A table has to have these nodes.
  std::vector<double> values(double theta_i, const Nodes& theta_s, const Nodes& phi) const {
    std::vector<double> result;
    if (model) {
      std::vector<DirectionPair> pairs;
      for (const double s : theta_s)
        for (const double azimuth : phi) pairs.push_back({theta_i, s, azimuth, 0});
      return model->brdf(pairs);
    }
    const auto slice = TableSlice::read(subject, subject.nodes_theta_i({&theta_i, 1})[0], band, polarization);
    std::vector<std::size_t> rows, columns;
    for (const double s : theta_s) rows.push_back(index_of(slice.theta_s(), s));
    for (const double azimuth : phi) {
      const auto at = std::find_if(slice.phi().begin(), slice.phi().end(), [&](double node) {
        return std::abs(in_circle(node) - azimuth) <= same_angle;
      });
      columns.push_back(static_cast<std::size_t>(at - slice.phi().begin()));
    }
    for (const std::size_t row : rows)
      for (const std::size_t column : columns) result.push_back(slice.value(row, column));
    return result;
  }

  static std::size_t index_of(const Nodes& nodes, double angle) {
    return static_cast<std::size_t>(std::lower_bound(nodes.begin(), nodes.end(), angle - same_angle) -
                                    nodes.begin());
  }
};

Nodes azimuths(const Grid& grid) {
  Nodes phi;
  for (const double node : grid.phi_s.nodes()) phi.push_back(in_circle(node - grid.phi_i[0]));
  std::sort(phi.begin(), phi.end());
  phi.erase(std::unique(phi.begin(), phi.end(), [](double a, double b) { return b - a <= same_angle; }),
            phi.end());
  return phi;
}

Nodes common(const Nodes& a, const Nodes& b) {
  Nodes result;
  for (const double angle : a)
    if (const auto at = std::lower_bound(b.begin(), b.end(), angle - same_angle);
        at != b.end() && *at <= angle + same_angle)
      result.push_back(angle);
  return result;
}

// The nodes that both have, where both are tables; otherwise those of the one table.
struct SharedNodes {
  Nodes theta_i, theta_s, phi;

  explicit SharedNodes(std::span<const Subject> subjects) {
    bool first = true;
    for (const Subject& subject : subjects) {
      if (!subject.is_table()) continue;
      const Grid& grid = subject.table().grid;
      const auto i = grid.theta_i.nodes(), s = grid.theta_s.nodes();
      const Nodes own_i(i.begin(), i.end()), own_s(s.begin(), s.end());
      theta_i = first ? own_i : common(theta_i, own_i);
      theta_s = first ? own_s : common(theta_s, own_s);
      phi = first ? azimuths(grid) : common(phi, azimuths(grid));
      first = false;
    }
  }
};

// The direction where the two differ most.
struct Worst {
  double logarithm = -1;  // |ln ratio|
  double ratio = 1;
  double theta_i = 0, theta_s = 0, phi = 0;

  void see(double ratio_there, double i, double s, double azimuth) {
    const double size = ratio_there > 0 ? std::abs(std::log(ratio_there)) : HUGE_VAL;
    if (size > logarithm) *this = {size, ratio_there, i, s, azimuth};
  }
};

// The ratio is 1 where both scatter nothing. Elsewhere it is 0 unless both are positive numbers.
double ratio_of(double a, double b) {
  if (a == 0 && b == 0) return 1;
  return a > 0 && b > 0 ? a / b : 0;
}

struct Comparison {
  std::vector<double> theta_i;
  std::vector<std::vector<double>> ratios;  // at the pixels of each map
  Worst worst;
  std::size_t directions = 0;
};

Comparison at_nodes(std::span<const Subject> subjects, const Side& a, const Side& b,
                    const PlotOptions& options) {
  const SharedNodes nodes(subjects);
  if (nodes.theta_i.empty() || nodes.theta_s.size() < 2 || nodes.phi.size() < 2)
    throw BadInput("{} and {} share {} theta_i, {} theta_s and {} azimuths: too few nodes to compare",
                   subjects[0].file(), subjects[1].file(), nodes.theta_i.size(), nodes.theta_s.size(),
                   nodes.phi.size());
  Comparison result;
  const auto nearest = [&](double angle) {
    return *std::min_element(nodes.theta_i.begin(), nodes.theta_i.end(),
                             [&](double x, double y) { return std::abs(x - angle) < std::abs(y - angle); });
  };
  const auto slice_at = [&](double theta_i) {
    const auto f = a.values(theta_i, nodes.theta_s, nodes.phi),
               g = b.values(theta_i, nodes.theta_s, nodes.phi);
    std::vector<double> ratios;
    for (std::size_t k = 0; k < f.size(); ++k) ratios.push_back(ratio_of(f[k], g[k]));
    return TableSlice(nodes.theta_s, nodes.phi, std::move(ratios));
  };
  const auto see = [&](double theta_i, const TableSlice& slice) {
    for (std::size_t s = 0; s < nodes.theta_s.size(); ++s)
      for (std::size_t k = 0; k < nodes.phi.size(); ++k)
        result.worst.see(slice.value(s, k), theta_i, nodes.theta_s[s], nodes.phi[k]);
    result.directions += nodes.theta_s.size() * nodes.phi.size();
  };
  if (options.theta_i) {
    for (const double angle : *options.theta_i) {
      if (std::abs(nearest(angle) - angle) > same_angle)
        throw BadInput(GivenValue{"theta_i", shortest(angle)}, "is no node of both; the nearest is {}",
                       shortest(nearest(angle)));
      result.theta_i.push_back(angle);
      see(angle, slice_at(angle));
    }
  } else {
    for (const double angle : nodes.theta_i) see(angle, slice_at(angle));
    for (const double angle : shown_incidences) result.theta_i.push_back(nearest(angle));
    result.theta_i.push_back(result.worst.theta_i);
    std::sort(result.theta_i.begin(), result.theta_i.end());
    result.theta_i.erase(std::unique(result.theta_i.begin(), result.theta_i.end()), result.theta_i.end());
  }
  for (const double angle : result.theta_i) {
    const TableSlice slice = slice_at(angle);
    if (!slice.is_round())
      throw BadInput("{} and {} share azimuths with gaps above 90 degrees", subjects[0].file(),
                     subjects[1].file());
    result.ratios.push_back(slice.at_pixels());
  }
  return result;
}

Comparison everywhere(const Side& a, const Side& b, const PlotOptions& options) {
  Comparison result;
  result.theta_i = options.theta_i
                       ? *options.theta_i
                       : std::vector<double>(std::begin(shown_incidences), std::end(shown_incidences));
  for (const double theta_i : result.theta_i) {
    const auto ratios = [&](std::span<const DirectionPair> pairs) {
      auto f = a.model->brdf(pairs);
      const auto g = b.model->brdf(pairs);
      for (std::size_t k = 0; k < f.size(); ++k) {
        f[k] = ratio_of(f[k], g[k]);
        if (pairs[k].model_theta_s() > farthest_compared) continue;
        result.worst.see(f[k], theta_i, pairs[k].model_theta_s(), in_circle(pairs[k].model_phi()));
        ++result.directions;
      }
      return f;
    };
    result.ratios.push_back(HemisphereFigure::pixels().values(theta_i, ratios));
    // The curve in the plane of incidence finds narrow lobes between the pixels; `ratios` notes what it sees.
    const double angles[] = {theta_i};
    in_plane_curves(angles, ratios);
  }
  return result;
}

// A symmetric scale: around 1 for ratios, or around 0 for ratios minus 1.
drawing::ChartAxis scale_for(double largest_logarithm, const std::string& quotient) {
  const double ratio = std::exp(std::min(largest_logarithm, std::log(largest_ratio_drawn)));
  if (ratio >= nearly_one) {
    double end = 1.5;
    for (const double next : {2.0, 5.0, 10.0, 20.0, 50.0, largest_ratio_drawn})
      if (end < ratio * 0.999) end = next;
    return {quotient, 1 / end, end, true};
  }
  const double off = std::max(std::expm1(largest_logarithm), least_difference_drawn);
  const double power = std::pow(10, std::floor(std::log10(off)));
  const double end = power * (off / power > 5 ? 10 : off / power > 2 ? 5 : off / power > 1 ? 2 : 1);
  return {quotient + " − 1", -end, end, false, end / 2};
}

std::string worst_text(const Worst& worst, const drawing::ChartAxis& scale) {
  if (worst.logarithm == 0) return "no difference anywhere";
  const std::string size = !(worst.ratio > 0)  ? "one is no positive number"
                           : scale.logarithmic ? fmt::format("ratio {:.4g}", worst.ratio)
                                               : fmt::format("{:+.3g}", worst.ratio - 1);
  return fmt::format("largest difference: {} at θ_i = {:.5g}°, θ_s = {:.5g}°, φ = {:.5g}°", size,
                     worst.theta_i, worst.theta_s, worst.phi);
}

}  // namespace

std::string compare_plot(std::span<const Subject> subjects, const PlotOptions& options,
                         const LazyEngine& engine) {
  const Polarization polarization = drawn_polarization(subjects, options);
  const auto side = [&](const Subject& subject) {
    const std::size_t band = subject.band(options.wavelength_nm);
    return Side{subject, band, polarization,
                subject.is_table()
                    ? std::nullopt
                    : std::optional<DrawnModel>(std::in_place, engine(), subject, band, polarization)};
  };
  const Side a = side(subjects[0]), b = side(subjects[1]);
  const bool of_nodes = subjects[0].is_table() || subjects[1].is_table();
  const Comparison comparison = of_nodes ? at_nodes(subjects, a, b, options) : everywhere(a, b, options);
  const auto labels = subject_labels(subjects);
  const drawing::ChartAxis scale = scale_for(comparison.worst.logarithm, "f_A / f_B");
  HemisphereFigure figure{
      .title = "Ratio of two BRDFs over the hemisphere",
      .subtitle = fmt::format("A: {}; B: {}; {}", labels[0], labels[1],
                              light_text(subjects[0], options, polarization)),
      .footnote = fmt::format("{}, of {} {}", worst_text(comparison.worst, scale), comparison.directions,
                              of_nodes ? "nodes" : "directions up to θ_s = 85°"),
      .scale = scale,
      .colours = &drawing::blue_to_orange,
      .columns = comparison.theta_i.size() <= 4 ? 4 : (comparison.theta_i.size() + 1) / 2,
      .maps = {}};
  for (std::size_t k = 0; k < comparison.theta_i.size(); ++k) {
    HemisphereMap map{fmt::format("θ_i = {}", incidence_label(comparison.theta_i[k])), comparison.theta_i[k],
                      comparison.ratios[k], std::nullopt};
    if (!scale.logarithmic)
      for (double& value : map.values) value -= 1;
    if (map.theta_i == comparison.worst.theta_i && comparison.worst.logarithm > 0)
      map.marked = {comparison.worst.theta_s, comparison.worst.phi};
    figure.maps.push_back(std::move(map));
  }
  return figure.svg();
}

}  // namespace brdftab

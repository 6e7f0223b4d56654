#include "host/table/grid_choice.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"

namespace brdftab {
namespace {

constexpr std::size_t measured_points = 20'000;  // the first half uniform
constexpr std::uint64_t density_seed = 1, calibration_seed = 2, first_measuring_seed = 3;
// The measured error is the largest of a sample: aim below what is asked.
constexpr double margin = 0.85;
constexpr double smallest_factor = 0.05, largest_factor = 16;
constexpr int bisections = 14;
// A grid that fresh points find too coarse gets this many times the intervals on each axis.
constexpr double refinement = 1.06;
constexpr int refinements = 20;
// Angles in files are short; far below any lobe's width.
constexpr double angles_per_degree = 1e6;
constexpr double uniform_growth = 1.05;
constexpr std::size_t most_uniform = 200'000;
constexpr double most_uniform_factor = 10;

AngleRange range_of(const Axis& axis) { return {axis.nodes().front(), axis.nodes().back()}; }

std::vector<double> rounded(std::vector<double> nodes) {
  for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
    nodes[k] = std::round(nodes[k] * angles_per_degree) / angles_per_degree;
  nodes.erase(std::unique(nodes.begin(), nodes.end(), [](double a, double b) { return !(b > a); }),
              nodes.end());
  return nodes;
}

std::vector<double> uniform_axis(AngleRange range, std::size_t nodes) {
  std::vector<double> result;
  for (std::size_t k = 0; k < nodes; ++k)
    result.push_back(range.first +
                     (range.last - range.first) * static_cast<double>(k) / static_cast<double>(nodes - 1));
  result.back() = range.last;
  return result;
}

std::size_t scaled(std::size_t nodes, double factor) {
  return static_cast<std::size_t>(static_cast<double>(nodes) * factor);
}

double nodes_of(const std::array<std::vector<double>, 3>& axes) {
  double product = 1;
  for (const auto& axis : axes) product *= static_cast<double>(std::max<std::size_t>(axis.size(), 1));
  return product;
}

std::string percent(double error) { return fmt::format("{:.3g} %", 100 * error); }

}  // namespace

// Angles of a table, uniform in the first half, near the forward and the retro-reflecting direction in the
// second.
struct GridChooser::Points {
  std::array<std::vector<double>, 3> angle;  // theta_i, theta_s, phi_s
  Directions directions;
  std::vector<std::vector<double>> f;
};

GridChooser::GridChooser(const Engine& engine, const Material& material,
                         const std::vector<Polarization>& polarizations, const Grid& ranges, double error)
    : watch_(engine.watch()),
      ranges_(ranges),
      error_(error),
      phi_i_(ranges.phi_i[0]),
      model_(engine, material, polarizations, range_of(ranges.theta_i), range_of(ranges.theta_s)),
      next_seed_(first_measuring_seed) {
  if (ranges.phi_i.size() > 1)
    throw BadInput(
        "phi_i has {} nodes: f depends on phi_s - phi_i only, so that a grid chosen by --interpolation-error "
        "has one",
        ranges.phi_i.size());
  const AngleRange theta_i = range_of(ranges.theta_i), theta_s = range_of(ranges.theta_s);
  DirectionDraw source(theta_i, theta_s, density_seed);
  // The errors of three axes add up at worst, on the ridges of lobes; equal shares take the fewest nodes.
  const auto add = [&](ChosenAxis axis, AngleRange whole, const Axis& given) {
    if (given.size() == 1) return;
    density_of_[static_cast<std::size_t>(axis)] = densities_.size();
    densities_.emplace_back(model_, axis, whole, error / 3, source);
  };
  add(ChosenAxis::theta_i, theta_i, ranges.theta_i);
  add(ChosenAxis::theta_s, theta_s, ranges.theta_s);
  add(ChosenAxis::phi, {0, 180}, ranges.phi_s);
}

// f is even and periodic in phi: the nodes of [0, 180], wherever the axis goes.
std::vector<double> GridChooser::unfolded(const std::vector<double>& phi) const {
  const AngleRange range = range_of(ranges_.phi_s);
  std::vector<double> nodes{range.first, range.last};
  for (int turn = -4; turn <= 4; ++turn)
    for (const double y : phi)
      for (const double x : {phi_i_ + 360 * turn - y, phi_i_ + 360 * turn + y})
        if (x > range.first && x < range.last) nodes.push_back(x);
  std::sort(nodes.begin(), nodes.end());
  return nodes;
}

GridChooser::Axes GridChooser::axes(double factor) const {
  Axes result;
  for (std::size_t k = 0; k < 3; ++k)
    if (density_of_[k]) result[k] = densities_[*density_of_[k]].nodes(factor);
  if (density_of_[2]) result[2] = unfolded(result[2]);
  for (auto& axis : result) axis = rounded(std::move(axis));
  return result;
}

Grid GridChooser::grid(const Axes& axes) const {
  Grid result = ranges_;
  if (density_of_[0]) result.theta_i = Axis(AxisKind::theta_i, axes[0]);
  if (density_of_[1]) result.theta_s = Axis(AxisKind::theta_s, axes[1]);
  if (density_of_[2]) result.phi_s = Axis(AxisKind::phi_s, axes[2]);
  return result;
}

GridChooser::Points GridChooser::draw(std::uint64_t seed) const {
  const AngleRange theta_i = range_of(ranges_.theta_i), theta_s = range_of(ranges_.theta_s),
                   phi_s = range_of(ranges_.phi_s);
  DirectionDraw source(theta_i, theta_s, seed);
  Points points;
  for (std::size_t k = 0; k < measured_points; ++k) {
    double i = source.theta_i(), s = source.uniform(theta_s.first, theta_s.last),
           q = source.uniform(phi_s.first, phi_s.last);
    if (k >= measured_points / 2) {
      s = source.near(i, theta_s);
      // The azimuth on either side, in any turn that the axis covers.
      const double phi = source.azimuth() * (source.uniform(-1, 1) < 0 ? -1 : 1);
      std::vector<double> turns;
      for (int turn = -4; turn <= 4; ++turn) {
        const double x = phi_i_ + phi + 360 * turn;
        if (x >= phi_s.first && x <= phi_s.last) turns.push_back(x);
      }
      if (!turns.empty())
        q = turns[static_cast<std::size_t>(source.uniform(0, static_cast<double>(turns.size())))];
    }
    points.angle[0].push_back(i);
    points.angle[1].push_back(s);
    points.angle[2].push_back(q);
    points.directions.add(i, s, q - phi_i_);
  }
  points.f = model_.evaluate(points.directions);
  return points;
}

GridError GridChooser::measure(const Axes& axes, const Points& points) const {
  watch_.stop_if_asked();
  const std::size_t count = points.directions.size();
  // The eight corners of each point's cell; an axis that is exact has its two corners at the point.
  std::array<std::vector<double>, 3> low = points.angle, high = points.angle, weight;
  for (std::size_t a = 0; a < 3; ++a) {
    weight[a].assign(count, 0);
    if (axes[a].size() < 2) continue;
    for (std::size_t k = 0; k < count; ++k) {
      const double x = points.angle[a][k];
      const auto at = std::upper_bound(axes[a].begin() + 1, axes[a].end() - 1, x);
      low[a][k] = *(at - 1);
      high[a][k] = *at;
      weight[a][k] = (x - low[a][k]) / (high[a][k] - low[a][k]);
    }
  }
  Directions corners;
  std::vector<double> shares;
  for (unsigned corner = 0; corner < 8; ++corner) {
    bool needed = true;
    for (std::size_t a = 0; a < 3; ++a) needed = needed && !((corner >> a & 1) && axes[a].size() < 2);
    if (!needed) continue;
    for (std::size_t k = 0; k < count; ++k) {
      double share = 1, angle[3];
      for (std::size_t a = 0; a < 3; ++a) {
        const bool upper = corner >> a & 1;
        share *= upper ? weight[a][k] : 1 - weight[a][k];
        angle[a] = upper ? high[a][k] : low[a][k];
      }
      corners.add(angle[0], angle[1], angle[2] - phi_i_);
      shares.push_back(share);
    }
  }
  const auto f = model_.evaluate(corners);
  std::vector<std::vector<double>> interpolated(f.size(), std::vector<double>(count, 0));
  for (std::size_t brdf = 0; brdf < f.size(); ++brdf)
    for (std::size_t k = 0; k < shares.size(); ++k) interpolated[brdf][k % count] += shares[k] * f[brdf][k];
  auto errors = relative_errors(model_, points.directions, points.f, interpolated);
  GridError result;
  result.points = count;
  result.uniform_maximum =
      *std::max_element(errors.begin(), errors.begin() + static_cast<std::ptrdiff_t>(count / 2));
  result.maximum = *std::max_element(errors.begin(), errors.end());
  result.percentile_95 = percentile(errors, 95);
  return result;
}

// The smallest factor that keeps calibration points within an error; errors fall with the factor, but for
// chance.
double GridChooser::factor_for(double error) const {
  const Points points = draw(calibration_seed);
  double low = smallest_factor, high = largest_factor;
  for (int k = 0; k < bisections; ++k) {
    const double middle = std::sqrt(low * high);
    (measure(axes(middle), points).maximum > error ? low : high) = middle;
  }
  return high;
}

GridAtError GridChooser::choose(double most_nodes) {
  factor_ = factor_for(margin * error_);
  for (int k = 0; k < refinements; ++k, factor_ *= refinement) {
    const Axes chosen = axes(factor_);
    if (nodes_of(chosen) > most_nodes) {
      double factor = factor_;
      while (factor > smallest_factor && nodes_of(axes(factor)) > most_nodes) factor /= refinement;
      throw BadInput(
          "an interpolation error of {} takes {:.4g} nodes, more than the {:.4g} of --max-nodes, with which "
          "{} is reached",
          percent(error_), nodes_of(chosen), most_nodes,
          percent(measure(axes(factor), draw(next_seed_)).maximum));
    }
    const GridError reached = measure(chosen, draw(next_seed_++));
    if (reached.maximum <= error_) return {grid(chosen), reached};
  }
  throw Error(Fault::check, "no grid was found that keeps the interpolation error within {}",
              percent(error_));
}

std::vector<GridAtError> GridChooser::other_sizes() {
  std::vector<GridAtError> result;
  const Points points = draw(next_seed_++);
  for (const double share : {0.35, 0.5, 0.7, 1.0, 1.4, 2.0}) {
    const Axes other = axes(factor_ * share);
    result.push_back({grid(other), measure(other, points)});
  }
  return result;
}

UniformNeed GridChooser::uniform_need(bool uniform_directions) {
  const Points points = draw(next_seed_++);
  const std::array ranges{range_of(ranges_.theta_i), range_of(ranges_.theta_s), range_of(ranges_.phi_s)};
  const auto within = [&](const Axes& uniform) {
    const GridError error = measure(uniform, points);
    return (uniform_directions ? error.uniform_maximum : error.maximum) <= error_;
  };
  UniformNeed need{{{1, 1, 1}}, {{1, 1, 1}}};
  for (std::size_t a = 0; a < 3; ++a) {
    if (!density_of_[a]) continue;
    std::size_t& nodes = need.alone.nodes[a] = 2;
    for (Axes one; nodes < most_uniform; nodes = std::max(nodes + 1, scaled(nodes, uniform_growth))) {
      one[a] = uniform_axis(ranges[a], nodes);
      if (within(one)) break;
    }
  }
  for (double factor = 1;; factor *= uniform_growth) {
    Axes all;
    for (std::size_t a = 0; a < 3; ++a) {
      if (!density_of_[a]) continue;
      need.together.nodes[a] = scaled(need.alone.nodes[a], factor);
      all[a] = uniform_axis(ranges[a], need.together.nodes[a]);
    }
    if (factor > most_uniform_factor || within(all)) return need;
  }
}

std::vector<AttributeInfo> GridChooser::attributes(const GridError& reached) const {
  return {{"interpolation",
           fmt::format("axes chosen for linear interpolation: |interpolated - f| / max(f, {} x the largest f "
                       "at that theta_i), at directions that the choice did not use, half of them uniform in "
                       "the angles, half near the forward and the retro-reflecting direction",
                       shortest(interpolation_floor))},
          {"interpolation_error_asked", error_},
          {"interpolation_error_reached", reached.maximum},
          {"interpolation_error_95_percent", reached.percentile_95},
          {"interpolation_error_uniform_directions", reached.uniform_maximum},
          {"interpolation_error_points", static_cast<double>(reached.points)},
          {"interpolation_floor", interpolation_floor}};
}

}  // namespace brdftab

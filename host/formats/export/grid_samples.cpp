#include "host/formats/export/grid_samples.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "host/base/error.hpp"
#include "host/model/grid_index.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

// A coordinate lies between two nodes, at a share of the way to the second.
struct Place {
  std::size_t low, high;
  double share;
};

Place place_in(const std::vector<double>& axis, double x) {
  const auto at = std::upper_bound(axis.begin(), axis.end(), x);
  if (at == axis.begin()) return {0, 0, 0};
  const auto high = static_cast<std::size_t>(at - axis.begin());
  if (at == axis.end()) return {high - 1, high - 1, 0};
  return {high - 1, high, (x - axis[high - 1]) / (axis[high] - axis[high - 1])};
}

// The azimuth phi_s is wrapped into a turn from the first node on. If there is a gap after the last node, the
// place lies across it, between the last node and the first.
Place azimuth_place(const std::vector<double>& axis, double phi_i, double phi) {
  const auto wrapped = [&](double x) { return x - 360 * std::floor((x - axis.front()) / 360); };
  double x = wrapped(phi_i + phi);
  if (x <= axis.back()) return place_in(axis, x);
  const double gap = axis.front() + 360 - axis.back();
  if (gap >= 180 - 1e-6) return place_in(axis, std::min(wrapped(phi_i - phi), axis.back()));
  return {axis.size() - 1, 0, (x - axis.back()) / gap};
}

}  // namespace

Directions directions_of(const Grid& grid) {
  Directions directions;
  for (auto* angles : {&directions.theta_i, &directions.theta_s, &directions.phi})
    angles->reserve(grid.directions());
  for (const double theta_i : grid.theta_i.nodes())
    for (const double phi_i : grid.phi_i.nodes())
      for (const double theta_s : grid.theta_s.nodes())
        for (const double phi_s : grid.phi_s.nodes()) directions.add(theta_i, theta_s, phi_s - phi_i);
  return directions;
}

std::vector<double> azimuths_away_from_surface(const Grid& grid) {
  if (grid.phi_i.size() > 1)
    throw BadInput(
        "phi_i has {} nodes: f depends on phi_s - phi_i only, and the file holds that; it takes one phi_i",
        grid.phi_i.size());
  std::set<double> azimuths{0, 360};
  for (const double phi_s : grid.phi_s.nodes()) {
    const double phi = std::fmod(phi_s - incident_azimuth(grid.phi_i[0]), 360);
    azimuths.insert(phi < 0 ? phi + 360 : phi);
  }
  return {azimuths.begin(), azimuths.end()};
}

GridSamples::GridSamples(Axes axes, std::vector<std::vector<double>> values, const std::string& source)
    : axes_(std::move(axes)), values_(std::move(values)) {
  std::size_t nodes = 1;
  for (const AxisRow& row : axis_table) {
    const auto& axis = axes_[static_cast<std::size_t>(row.kind)];
    nodes *= axis.size();
    // The comparison is written so that it refuses a nan, too.
    const bool increases = std::adjacent_find(axis.begin(), axis.end(),
                                              [](double a, double b) { return !(a < b); }) == axis.end();
    if (axis.empty() || !std::isfinite(axis.front()) || !std::isfinite(axis.back()) || !increases)
      throw BadInput("{}: {}: its angles must be finite and increase strictly", source, row.name);
  }
  for (const auto& channel : values_)
    if (channel.size() != nodes)
      throw BadInput("{}: has {} samples where its axes have {} nodes", source, channel.size(), nodes);
}

GridSamples GridSamples::with_values(std::vector<std::vector<double>> values) const {
  GridSamples result = *this;
  result.values_ = std::move(values);
  return result;
}

Directions GridSamples::directions() const {
  Directions directions;
  for (const double theta_i : axes_[0])
    for (const double phi_i : axes_[1])
      for (const double theta_s : axes_[2])
        for (const double phi_s : axes_[3]) directions.add(theta_i, theta_s, phi_s - phi_i);
  return directions;
}

AngleRange GridSamples::phi_range() const {
  constexpr double rounding = 1e-6;
  const auto& phi = axis(AxisKind::phi_s);
  const double first = phi.front() - axis(AxisKind::phi_i).front(), turn = phi.back() - phi.front(),
               gap = 360 - turn;
  double widest = 0;
  for (std::size_t k = 1; k < phi.size(); ++k) widest = std::max(widest, phi[k] - phi[k - 1]);
  const bool goes_round = gap < 180 - rounding && gap <= 2 * widest + rounding;
  const bool is_half = std::abs(turn - 180) < rounding && std::abs(std::remainder(first, 180)) < rounding;
  return goes_round || is_half ? AngleRange{-180, 180} : AngleRange{first, first + turn};
}

GridSamples GridSamples::from_rows(const std::vector<std::vector<double>>& columns,
                                   const std::string& source) {
  const std::size_t rows = columns.front().size();
  Axes axes;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    axes[k] = columns[k];
    std::sort(axes[k].begin(), axes[k].end());
    axes[k].erase(std::unique(axes[k].begin(), axes[k].end()), axes[k].end());
  }
  const GridIndex order({axes[0].size(), axes[1].size(), axes[2].size(), axes[3].size()});
  if (rows == 0 || order.size() != rows)
    throw BadInput("{}: has {} rows, which are not every node of a grid of {} x {} x {} x {} angles once",
                   source, rows, axes[0].size(), axes[1].size(), axes[2].size(), axes[3].size());
  std::vector<std::vector<double>> values(columns.size() - 4, std::vector<double>(rows, NAN));
  for (std::size_t row = 0; row < rows; ++row) {
    GridNode at{};
    for (const AxisRow& axis : axis_table) {
      const auto k = static_cast<std::size_t>(axis.kind);
      const auto place = std::lower_bound(axes[k].begin(), axes[k].end(), columns[k][row]);
      at[axis.kind] = static_cast<std::size_t>(place - axes[k].begin());
    }
    const std::size_t node = order.flat(at);
    if (!std::isnan(values[0][node]))
      throw BadInput("{}: has the directions theta_i = {}, phi_i = {}, theta_s = {}, phi_s = {} twice",
                     source, columns[0][row], columns[1][row], columns[2][row], columns[3][row]);
    for (std::size_t c = 0; c < values.size(); ++c) values[c][node] = columns[4 + c][row];
  }
  return {std::move(axes), std::move(values), source};
}

std::vector<std::vector<double>> GridSamples::evaluate(const Directions& directions) const {
  std::vector<std::vector<double>> f(values_.size(), std::vector<double>(directions.size()));
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const std::array places{place_in(axes_[0], directions.theta_i[k]), Place{0, 0, 0},
                            place_in(axes_[2], directions.theta_s[k]),
                            azimuth_place(axes_[3], axes_[1].front(), directions.phi[k])};
    for (unsigned corner = 0; corner < 16; ++corner) {
      double weight = 1;
      std::size_t node = 0;
      for (unsigned a = 0; a < 4; ++a) {
        const bool high = corner >> a & 1;
        weight *= high ? places[a].share : 1 - places[a].share;
        node = node * axes_[a].size() + (high ? places[a].high : places[a].low);
      }
      if (weight == 0) continue;
      for (std::size_t c = 0; c < f.size(); ++c) f[c][k] += weight * values_[c][node];
    }
  }
  return f;
}

}  // namespace brdftab

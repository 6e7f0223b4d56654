#include "host/pictures/table_slice.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/pictures/hemisphere_figure.hpp"

namespace brdftab {
namespace {

constexpr double same_angle = 1e-9;  // degrees
constexpr double widest_gap = 90;    // degrees
constexpr std::size_t most_nodes = 1 << 27;

std::vector<double> azimuths(const Grid& grid) {
  std::vector<double> phi;
  for (const double node : grid.phi_s.nodes()) phi.push_back(node - grid.phi_i[0]);
  return phi;
}

}  // namespace

bool has_hemispheres(const Grid& grid) { return TableSlice({0}, azimuths(grid), {}).is_round(); }

double in_circle(double phi) {
  const double turned = std::fmod(phi, 360);
  const double positive = turned < 0 ? turned + 360 : turned;
  return positive > 360 - same_angle ? 0 : positive;
}

TableSlice TableSlice::read(const Subject& subject, std::size_t theta_i, std::size_t band,
                            Polarization polarization) {
  const Grid& grid = subject.table().grid;
  const Slab box{{theta_i, theta_i + 1}, {0, 1}, {0, grid.theta_s.size()}, grid.phi_s.size()};
  if (box.nodes() > most_nodes)
    throw BadInput("{}: a hemisphere of this table has {} nodes: at most {} can be drawn", subject.file(),
                   box.nodes(), most_nodes);
  std::vector<double> values(box.nodes());
  subject.reader().read(polarization, band, box, values);
  const auto theta_s = grid.theta_s.nodes();
  return TableSlice({theta_s.begin(), theta_s.end()}, azimuths(grid), std::move(values));
}

TableSlice::TableSlice(std::vector<double> theta_s, std::vector<double> phi, std::vector<double> values)
    : theta_s_(std::move(theta_s)), phi_(std::move(phi)), values_(std::move(values)) {
  for (std::size_t k = 0; k < phi_.size(); ++k) circle_.push_back({in_circle(phi_[k]), k});
  // The images in the plane of incidence come last, so that a node of its own has the place before an image.
  for (std::size_t k = 0; k < phi_.size(); ++k) circle_.push_back({in_circle(-phi_[k]), k});
  std::stable_sort(circle_.begin(), circle_.end(),
                   [](const Azimuth& a, const Azimuth& b) { return a.phi < b.phi - same_angle; });
  circle_.erase(
      std::unique(circle_.begin(), circle_.end(),
                  [](const Azimuth& a, const Azimuth& b) { return std::abs(a.phi - b.phi) <= same_angle; }),
      circle_.end());
  circle_.push_back({circle_.front().phi + 360, circle_.front().column});
}

bool TableSlice::is_round() const {
  for (std::size_t k = 1; k < circle_.size(); ++k)
    if (circle_[k].phi - circle_[k - 1].phi > widest_gap + same_angle) return false;
  return true;
}

double TableSlice::at(double theta_s, double phi) const {
  if (theta_s < theta_s_.front() - same_angle || theta_s > theta_s_.back() + same_angle) return std::nan("");
  const auto above = std::upper_bound(theta_s_.begin(), theta_s_.end(), theta_s);
  const auto row = static_cast<std::size_t>(std::max<std::ptrdiff_t>(above - theta_s_.begin() - 1, 0));
  const std::size_t next_row = std::min(row + 1, theta_s_.size() - 1);
  const double down =
      next_row > row ? std::clamp((theta_s - theta_s_[row]) / (theta_s_[next_row] - theta_s_[row]), 0.0, 1.0)
                     : 0;
  double turned = in_circle(phi);
  if (turned < circle_.front().phi) turned += 360;
  auto next = std::upper_bound(circle_.begin(), circle_.end(), turned,
                               [](double a, const Azimuth& b) { return a < b.phi; });
  next = std::clamp(next, circle_.begin() + 1, circle_.end() - 1);
  const Azimuth& left = *(next - 1);
  const double along = std::clamp((turned - left.phi) / (next->phi - left.phi), 0.0, 1.0);
  const double corners[4] = {value(row, left.column), value(row, next->column), value(next_row, left.column),
                             value(next_row, next->column)};
  const double weights[4] = {(1 - down) * (1 - along), (1 - down) * along, down * (1 - along), down * along};
  const bool logarithmic = std::all_of(corners, corners + 4, [](double f) { return f > 0; });
  double sum = 0;
  for (int k = 0; k < 4; ++k) sum += weights[k] * (logarithmic ? std::log(corners[k]) : corners[k]);
  return logarithmic ? std::exp(sum) : sum;
}

std::vector<double> TableSlice::at_pixels() const {
  const HemispherePixels pixels = HemisphereFigure::pixels();
  const double last = theta_s_.back();
  const double reach = std::sin(radians(last)) + 2.0 / static_cast<double>(pixels.side());
  return pixels.values(0, [&](std::span<const DirectionPair> pairs) {
    std::vector<double> values;
    for (const DirectionPair& pair : pairs)
      values.push_back(std::sin(radians(pair.theta_s)) < reach ? at(std::min(pair.theta_s, last), pair.phi)
                                                               : std::nan(""));
    return values;
  });
}

std::vector<drawing::ChartPoint> TableSlice::in_plane() const {
  std::vector<drawing::ChartPoint> points;
  for (const auto& [phi, sign] : {std::pair{180.0, -1.0}, {0.0, 1.0}}) {
    const auto at = std::find_if(circle_.begin(), circle_.end(),
                                 [&](const Azimuth& a) { return std::abs(a.phi - phi) <= same_angle; });
    if (at == circle_.end()) continue;
    for (std::size_t row = 0; row < theta_s_.size(); ++row)
      if (theta_s_[row] > 0 || sign > 0) points.push_back({sign * theta_s_[row], value(row, at->column)});
  }
  std::sort(points.begin(), points.end(),
            [](const drawing::ChartPoint& a, const drawing::ChartPoint& b) { return a.x < b.x; });
  return points;
}

}  // namespace brdftab

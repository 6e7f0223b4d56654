#include "host/model/measurement/incidences.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdftab {
namespace {

constexpr double finest_label = 1e-6, coarsest_label = 1e-2;  // degrees
// Steps of a regular scan differ in their last bits; they count as equal, lest rounding decide which of them
// are joined.
constexpr double same_step = 1e-7;

double rounded(double mean, double spread) {
  const double decade = std::pow(10, std::floor(std::log10(0.5 * spread)));
  // A division by a whole number of steps rounds to the nearest decimal.
  const double steps = std::round(1 / std::clamp(decade, finest_label, coarsest_label));
  return std::round(mean * steps) / steps;
}

}  // namespace

std::vector<Incidences::Group> Incidences::join(const std::vector<Group>& groups, double width) {
  // The other end of each run of groups; it holds at the run's own two ends.
  std::vector<std::size_t> first(groups.size()), last(groups.size());
  std::iota(first.begin(), first.end(), 0);
  std::iota(last.begin(), last.end(), 0);
  std::vector<std::size_t> gaps;  // between a group and the one before
  for (std::size_t k = 1; k < groups.size(); ++k) gaps.push_back(k);
  const auto step = [&](std::size_t k) {
    return std::round((groups[k].lowest - groups[k - 1].highest) / same_step);
  };
  std::stable_sort(gaps.begin(), gaps.end(), [&](std::size_t a, std::size_t b) { return step(a) < step(b); });
  for (const std::size_t k : gaps) {
    const std::size_t low = first[k - 1], high = last[k];
    if (groups[high].highest - groups[low].lowest > width - same_step) continue;
    last[low] = high;
    first[high] = low;
  }
  std::vector<Group> result;
  for (std::size_t k = 0; k < groups.size(); k = last[k] + 1) {
    result.push_back({groups[k].lowest, groups[last[k]].highest, 0, 0});
    for (std::size_t j = k; j <= last[k]; ++j) {
      result.back().sum += groups[j].sum;
      result.back().count += groups[j].count;
    }
  }
  return result;
}

Incidences::Incidences(std::span<const double> theta_i, double width) : width_(width) {
  std::vector<double> sorted(theta_i.begin(), theta_i.end());
  std::sort(sorted.begin(), sorted.end());
  std::vector<Group> distinct;
  for (const double angle : sorted) {
    if (distinct.empty() || angle > distinct.back().lowest) distinct.push_back({angle, angle, 0, 0});
    distinct.back().sum += angle;
    ++distinct.back().count;
  }
  groups_ = join(distinct, width);
}

Incidences Incidences::joined(std::size_t most) const {
  Incidences result = *this;
  while (result.size() > most) {
    result.width_ = std::max(2 * result.width_, usual_width);
    result.groups_ = join(groups_, result.width_);
  }
  return result;
}

double Incidences::angle(std::size_t group) const {
  const Group& g = groups_[group];
  return g.lowest == g.highest ? g.lowest : rounded(g.sum / g.count, g.highest - g.lowest);
}

std::vector<double> Incidences::angles() const {
  std::vector<double> result;
  for (std::size_t k = 0; k < size(); ++k) result.push_back(angle(k));
  return result;
}

std::size_t Incidences::index(double theta_i) const {
  const auto after = std::upper_bound(groups_.begin(), groups_.end(), theta_i,
                                      [](double x, const Group& g) { return x < g.lowest; });
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - groups_.begin() - 1, 0));
}

}  // namespace brdftab

#include "host/table/axis_density.hpp"

#include <algorithm>
#include <cmath>

#include "host/model/axis.hpp"

namespace brdftab {
namespace {

constexpr std::size_t first_intervals = 60;
constexpr int rounds = 7;
constexpr int enveloping_rounds = 2;  // the last ones, which agree on the density but for chance
constexpr std::size_t probes = 300;   // of an interval
constexpr std::size_t neighbours = 2;
constexpr double growth = 4;
constexpr std::size_t most_intervals = 20'000;
constexpr double least_intervals = 4;
// An interval that misses a lobe altogether says no more than that.
constexpr double largest_error = 1e3;

// The error half way along each interval, the largest over directions of the other angles.
std::vector<double> interval_errors(const SampledModel& model, ChosenAxis axis,
                                    const std::vector<double>& nodes, DirectionDraw& source) {
  const std::size_t intervals = nodes.size() - 1;
  Directions middle, ends[2];
  const auto add = [&](Directions& to, double x, double other, double azimuth) {
    if (axis == ChosenAxis::theta_i) to.add(x, other, azimuth);
    if (axis == ChosenAxis::theta_s) to.add(other, x, azimuth);
    // `azimuth` stands for theta_s.
    if (axis == ChosenAxis::phi) to.add(other, azimuth, x);
  };
  for (std::size_t k = 0; k < intervals; ++k) {
    const double x = 0.5 * (nodes[k] + nodes[k + 1]);
    for (std::size_t j = 0; j < probes; ++j) {
      double first, second;
      if (axis == ChosenAxis::phi) {
        first = j % 4 == 0 ? source.theta_i_range().last : source.theta_i();
        second = source.near(first, source.theta_s_range());
      } else {
        first = source.near(x, axis == ChosenAxis::theta_i ? source.theta_s_range() : source.theta_i_range());
        second = source.azimuth();
      }
      add(middle, x, first, second);
      add(ends[0], nodes[k], first, second);
      add(ends[1], nodes[k + 1], first, second);
    }
  }
  const auto f = model.evaluate(middle);
  auto mean = model.evaluate(ends[0]);
  const auto other = model.evaluate(ends[1]);
  for (std::size_t brdf = 0; brdf < mean.size(); ++brdf)
    for (std::size_t k = 0; k < mean[brdf].size(); ++k)
      mean[brdf][k] = 0.5 * (mean[brdf][k] + other[brdf][k]);
  const auto errors = relative_errors(model, middle, f, mean);
  std::vector<double> largest(intervals);
  for (std::size_t k = 0; k < intervals; ++k)
    largest[k] = *std::max_element(errors.begin() + static_cast<std::ptrdiff_t>(k * probes),
                                   errors.begin() + static_cast<std::ptrdiff_t>((k + 1) * probes));
  return largest;
}

// The largest among neighbours: probes miss a lobe by chance.
std::vector<double> widened(const std::vector<double>& values) {
  std::vector<double> result(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t begin = k - std::min(k, neighbours), end = std::min(k + neighbours + 1, values.size());
    result[k] = *std::max_element(values.begin() + static_cast<std::ptrdiff_t>(begin),
                                  values.begin() + static_cast<std::ptrdiff_t>(end));
  }
  return result;
}

// y at x between points, x increasing; the ends beyond them.
double linear(const std::vector<double>& xs, const std::vector<double>& ys, double x) {
  const auto at = std::upper_bound(xs.begin(), xs.end(), x);
  if (at == xs.begin()) return ys.front();
  if (at == xs.end()) return ys.back();
  const auto k = static_cast<std::size_t>(at - xs.begin());
  return ys[k - 1] + (ys[k] - ys[k - 1]) * (x - xs[k - 1]) / (xs[k] - xs[k - 1]);
}

std::vector<double> middles(const std::vector<double>& nodes) {
  std::vector<double> result;
  for (std::size_t k = 1; k < nodes.size(); ++k) result.push_back(0.5 * (nodes[k - 1] + nodes[k]));
  return result;
}

std::vector<double> spread(const std::vector<double>& angle, const std::vector<double>& intervals,
                           std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t k = 0; k <= count; ++k)
    nodes.push_back(
        linear(intervals, angle, intervals.back() * static_cast<double>(k) / static_cast<double>(count)));
  nodes.front() = angle.front();
  nodes.back() = angle.back();
  return nodes;
}

}  // namespace

DirectionDraw::DirectionDraw(AngleRange theta_i, AngleRange theta_s, std::uint64_t seed)
    : theta_i_(theta_i), theta_s_(theta_s), random_(seed) {}

double DirectionDraw::uniform(double low, double high) {
  return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
}

double DirectionDraw::theta_i() { return uniform(theta_i_.first, theta_i_.last); }

double DirectionDraw::near(double x, AngleRange range) {
  const auto kind = random_() % 8;
  double angle = x;
  if (kind < 3) return uniform(range.first, range.last);
  if (kind < 6) angle += std::copysign(std::pow(10, uniform(-2.5, 1.3)), uniform(-1, 1));
  if (kind == 7) angle = uniform(0, 1) < 0.3 ? range.first : range.last;
  return std::clamp(angle, range.first, range.last);
}

double DirectionDraw::azimuth() {
  switch (random_() % 4) {
    case 0:
      return uniform(0, 180);
    case 1:
      return std::pow(10, uniform(-3, 1.6));
    case 2:
      return 180 - std::pow(10, uniform(-3, 1.6));
    default:
      return uniform(0, 1) < 0.5 ? 0 : 180;
  }
}

std::vector<double> relative_errors(const SampledModel& model, const Directions& directions,
                                    const std::vector<std::vector<double>>& f,
                                    const std::vector<std::vector<double>>& interpolated) {
  std::vector<double> errors(directions.size(), 0);
  for (std::size_t brdf = 0; brdf < f.size(); ++brdf)
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const double scale =
          std::max(f[brdf][k], interpolation_floor * model.peak(brdf, directions.theta_i[k]));
      errors[k] = std::max(errors[k], std::abs(interpolated[brdf][k] - f[brdf][k]) / scale);
    }
  return errors;
}

AxisDensity::AxisDensity(const SampledModel& model, ChosenAxis axis, AngleRange range, double error,
                         DirectionDraw& source) {
  angle_ = spread({range.first, range.last}, {0, 1}, first_intervals);
  std::vector<double> envelope_at, envelope;
  for (int round = 0;; ++round) {
    const auto errors = widened(interval_errors(model, axis, angle_, source));
    std::vector<double> density;
    for (std::size_t k = 0; k < errors.size(); ++k)
      density.push_back(
          std::max(std::sqrt(std::min(errors[k], largest_error) / error) / (angle_[k + 1] - angle_[k]),
                   least_intervals / (range.last - range.first)));
    const auto at = middles(angle_);
    if (round >= rounds - enveloping_rounds) {
      if (!envelope.empty())
        for (std::size_t k = 0; k < at.size(); ++k)
          density[k] = std::max(density[k], linear(envelope_at, envelope, at[k]));
      envelope_at = at;
      envelope = density;
    }
    intervals_.assign(1, 0);
    for (std::size_t k = 0; k < density.size(); ++k)
      intervals_.push_back(intervals_.back() + density[k] * (angle_[k + 1] - angle_[k]));
    if (round + 1 == rounds) return;
    const double wanted = std::min({std::ceil(intervals_.back()), growth * static_cast<double>(angle_.size()),
                                    static_cast<double>(most_intervals)});
    angle_ = spread(angle_, intervals_, static_cast<std::size_t>(wanted));
  }
}

std::vector<double> AxisDensity::nodes(double factor) const {
  const double count =
      std::clamp(std::ceil(intervals_.back() * factor), 1.0, static_cast<double>(longest_axis - 1));
  return spread(angle_, intervals_, static_cast<std::size_t>(count));
}

}  // namespace brdftab

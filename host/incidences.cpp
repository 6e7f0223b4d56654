#include "host/incidences.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace brdftab {
namespace {

constexpr double finest_label = 1e-6, coarsest_label = 1e-2;  // degrees
// Steps of a regular scan differ in their last bits; they count as equal, lest rounding decide which of them are joined.
constexpr double same_step = 1e-7;

double rounded(double mean, double spread) {
  if (spread == 0) return mean;
  const double decade = std::pow(10, std::floor(std::log10(0.5 * spread)));
  // 1/step is a whole number: to divide by it rounds to the nearest decimal.
  const double steps = std::round(1 / std::clamp(decade, finest_label, coarsest_label));
  return std::round(mean * steps) / steps;
}

}  // namespace

Incidences::Incidences(std::span<const double> theta_i, double width) {
  std::vector<double> sorted(theta_i.begin(), theta_i.end());
  std::sort(sorted.begin(), sorted.end());
  // Where each group begins and ends, at its first and last element only.
  std::vector<std::size_t> first(sorted.size()), last(sorted.size()), gaps;
  std::iota(first.begin(), first.end(), 0);
  std::iota(last.begin(), last.end(), 0);
  for (std::size_t k = 1; k < sorted.size(); ++k) gaps.push_back(k);
  const auto step = [&](std::size_t k) { return std::round((sorted[k] - sorted[k - 1]) / same_step); };
  std::stable_sort(gaps.begin(), gaps.end(), [&](std::size_t a, std::size_t b) { return step(a) < step(b); });
  for (const std::size_t k : gaps) {
    const std::size_t low = first[k - 1], high = last[k];
    const double spread = sorted[high] - sorted[low];
    if (spread > 0 && spread > width - same_step) continue;
    last[low] = high;
    first[high] = low;
  }
  for (std::size_t k = 0; k < sorted.size(); k = last[k] + 1) {
    const std::size_t end = last[k] + 1;
    const double low = sorted[k], high = sorted[end - 1];
    double above = 0;
    for (std::size_t j = k; j < end; ++j) above += sorted[j] - low;
    lowest_.push_back(low);
    highest_.push_back(high);
    angles_.push_back(rounded(low + above / static_cast<double>(end - k), high - low));
  }
}

std::size_t Incidences::index(double theta_i) const {
  const auto after = std::upper_bound(lowest_.begin(), lowest_.end(), theta_i);
  return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - lowest_.begin() - 1, 0));
}

}  // namespace brdftab

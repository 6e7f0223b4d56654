#include "host/compute/normalization_nodes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "host/compute/polar_stretch.hpp"

namespace brdftab {
namespace {

// In t. A panel ends where a node more costs less than the empty room up to the next angle, and before it
// takes more nodes than `width`.
constexpr double widest_panel = 0.25;
constexpr double widest_gap = 0.08;
// How far from the real axis N stays analytic, nearly; and the relative error that nodes are chosen for.
constexpr double analytic_radius = 0.35;
constexpr double tolerance = 1e-11;

// Chebyshev interpolation of a function that is analytic within `analytic_radius` errs by about rho^-count.
std::size_t nodes_needed(double panel) {
  if (panel < 1e-12) return 1;
  return static_cast<std::size_t>(std::ceil(-std::log(tolerance) / std::log(4 * analytic_radius / panel)));
}

// Barycentric weights of Chebyshev nodes of the first kind; exactly one node where x is it.
std::vector<double> shares(std::span<const double> nodes, double x) {
  std::vector<double> result(nodes.size());
  double sum = 0;
  for (std::size_t j = 0; j < nodes.size(); ++j) {
    if (x == nodes[j]) {
      std::fill(result.begin(), result.end(), 0);
      result[j] = 1;
      return result;
    }
    const double sine = std::sin((2 * static_cast<double>(j) + 1) * std::numbers::pi /
                                 (2 * static_cast<double>(nodes.size())));
    result[j] = (j % 2 ? -sine : sine) / (x - nodes[j]);
    sum += result[j];
  }
  for (double& share : result) share /= sum;
  return result;
}

std::vector<double> chebyshev(double low, double high, std::size_t count) {
  std::vector<double> nodes;
  for (std::size_t j = 0; j < count; ++j) {
    const double cosine =
        std::cos((2 * static_cast<double>(j) + 1) * std::numbers::pi / (2 * static_cast<double>(count)));
    nodes.push_back(0.5 * (low + high) + 0.5 * (high - low) * cosine);
  }
  return nodes;
}

}  // namespace

NormalizationNodes::NormalizationNodes(std::span<const double> theta)
    : first_(theta.size()), count_(theta.size(), 1), share_(theta.size() * width) {
  std::vector<std::size_t> order(theta.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return theta[a] < theta[b]; });
  std::vector<double> t;
  for (const std::size_t k : order) t.push_back(stretched(theta[k]));
  for (std::size_t begin = 0, end = 0; begin < t.size(); begin = end) {
    for (end = begin + 1;
         end < t.size() && t[end] - t[begin] <= widest_panel && t[end] - t[end - 1] <= widest_gap;)
      ++end;
    const double low = t[begin], high = t[end - 1];
    const std::size_t needed = nodes_needed(high - low);
    const int first = static_cast<int>(theta_.size());
    if (end - begin <= needed) {
      for (std::size_t k = begin; k < end; ++k) {
        first_[order[k]] = static_cast<int>(theta_.size());
        share_[order[k] * width] = 1;
        theta_.push_back(theta[order[k]]);
      }
      continue;
    }
    interpolates_ = true;
    const auto nodes = chebyshev(low, high, needed);
    for (const double node : nodes) theta_.push_back(unstretched(node));
    for (std::size_t k = begin; k < end; ++k) {
      first_[order[k]] = first;
      count_[order[k]] = static_cast<int>(needed);
      std::ranges::copy(shares(nodes, t[k]), share_.begin() + static_cast<std::ptrdiff_t>(order[k] * width));
    }
  }
  if (!interpolates_) theta_.assign(theta.begin(), theta.end());
}

}  // namespace brdftab

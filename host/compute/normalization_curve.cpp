#include "host/compute/normalization_curve.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "host/compute/normalizations.hpp"
#include "host/compute/polar_stretch.hpp"

namespace brdftab {
namespace {

constexpr double step = 0.0237;

}  // namespace

NormalizationCurve::NormalizationCurve(const Engine& engine, const Band& band, const Variant& variant,
                                       double largest_theta) {
  const auto nodes = static_cast<std::size_t>(stretched(largest_theta) / step) + Stencil::width / 2 + 1;
  std::vector<double> theta{0};
  while (theta.size() < std::max<std::size_t>(nodes, Stencil::width))
    theta.push_back(unstretched(static_cast<double>(theta.size()) * step));
  const auto n = normalizations(engine, band, variant, theta);
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    for (const double value : n.value[lobe]) log_n_[lobe].push_back(std::log(value));
}

NormalizationCurve::Stencil NormalizationCurve::stencil(double theta) {
  const double x = stretched(theta) / step;
  Stencil result{.first = static_cast<std::ptrdiff_t>(x) - Stencil::width / 2 + 1, .share = {}};
  double sum = 0;
  double binomial = 1;
  for (std::ptrdiff_t j = 0; j < Stencil::width; ++j) {
    const double distance = x - static_cast<double>(result.first + j);
    auto& share = result.share[static_cast<std::size_t>(j)];
    if (distance == 0) {
      result.share = {};
      share = 1;
      return result;
    }
    share = (j % 2 ? -binomial : binomial) / distance;
    sum += share;
    binomial *= static_cast<double>(Stencil::width - 1 - j) / static_cast<double>(j + 1);
  }
  for (double& share : result.share) share /= sum;
  return result;
}

double NormalizationCurve::operator()(std::size_t lobe, const Stencil& stencil) const {
  double log_n = 0;
  for (std::ptrdiff_t j = 0; j < Stencil::width; ++j)
    log_n += stencil.share[static_cast<std::size_t>(j)] *
             log_n_[lobe][static_cast<std::size_t>(std::abs(stencil.first + j))];
  return std::exp(log_n);
}

}  // namespace brdftab

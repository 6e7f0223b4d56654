#include "host/table/validation/spot_check.hpp"

#include <cmath>
#include <cstring>
#include <random>

#include "host/reference/model.hpp"

namespace brdftab {
namespace {

constexpr std::size_t incidences = 3;
constexpr std::size_t nodes_per_incidence = 32;

double sample_at(std::span<const std::byte> samples, std::size_t index, Precision precision) {
  if (precision == Precision::float64) {
    double value;
    std::memcpy(&value, samples.data() + index * sizeof value, sizeof value);
    return value;
  }
  float value;
  std::memcpy(&value, samples.data() + index * sizeof value, sizeof value);
  return value;
}

bool contains(Range range, std::size_t k) { return k >= range.begin && k < range.end; }

}  // namespace

SpotCheck::SpotCheck(const TableContent& content) : content_(content) {
  std::mt19937_64 random(20080101);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  for (std::size_t k = 0; k < incidences; ++k) {
    const std::size_t band = below(content.material.bands().size());
    const std::size_t theta_i = below(content.grid.theta_i.size());
    for (std::size_t j = 0; j < nodes_per_incidence; ++j)
      nodes_.push_back({below(content.polarizations.size()), band, theta_i, below(content.grid.phi_i.size()),
                        below(content.grid.theta_s.size()), below(content.grid.phi_s.size()), NAN});
  }
}

void SpotCheck::take(std::size_t polarization, std::size_t band, const Slab& slab,
                     std::span<const std::byte> samples) {
  for (Node& node : nodes_) {
    if (node.polarization != polarization || node.band != band || !contains(slab.theta_i, node.theta_i) ||
        !contains(slab.phi_i, node.phi_i) || !contains(slab.theta_s, node.theta_s))
      continue;
    const std::size_t incidence =
        (node.theta_i - slab.theta_i.begin) * slab.phi_i.size() + (node.phi_i - slab.phi_i.begin);
    const std::size_t row = incidence * slab.theta_s.size() + (node.theta_s - slab.theta_s.begin);
    node.value = sample_at(samples, row * slab.phi_s + node.phi_s, content_.precision);
  }
}

Accuracy SpotCheck::compare() const {
  std::vector<reference::Model> models;
  for (const Band& band : content_.material.bands())
    models.emplace_back(band.parameters, content_.material.variant());
  const Grid& grid = content_.grid;
  Accuracy accuracy;
  double sum = 0;
  for (const Node& node : nodes_) {
    const auto f = models[node.band].brdf(grid.theta_i[node.theta_i], grid.theta_s[node.theta_s],
                                          grid.phi_s[node.phi_s] - grid.phi_i[node.phi_i]);
    const auto polarization = content_.polarizations[node.polarization];
    const double expected = (polarization == Polarization::s   ? f.s
                             : polarization == Polarization::p ? f.p
                                                               : f.unpolarized())
                                .total();
    if (expected < smallest_compared) continue;
    const double error = std::abs(node.value / expected - 1);
    // Written so that a nan counts as the largest error.
    if (!(error <= accuracy.max_relative_error)) accuracy.max_relative_error = error;
    sum += error * error;
    ++accuracy.nodes;
  }
  if (accuracy.nodes > 0) accuracy.rms_relative_error = std::sqrt(sum / static_cast<double>(accuracy.nodes));
  return accuracy;
}

}  // namespace brdftab

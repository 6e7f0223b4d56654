#include "host/table/validation/node_check.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "host/base/parallel.hpp"
#include "host/table/validation/spot_check.hpp"

namespace brdftab {
namespace {

constexpr std::size_t slab_nodes = 1 << 21;
constexpr std::size_t nodes_per_task = 256;
// Each theta_i costs the reference an integral.
constexpr std::size_t most_incidences = 64;
constexpr std::size_t random_incidences = 32;
constexpr std::size_t rows_by_default = 64;
// Nodes that the kernels find furthest off are judged by the reference.
constexpr std::size_t most_suspects = 256;
constexpr double suspect_share = 0.25;

double relative_error(double stored, double expected) {
  if (!std::isfinite(stored)) return std::numeric_limits<double>::infinity();
  if (std::abs(expected) < smallest_compared)
    return std::abs(stored) < smallest_compared ? 0 : std::numeric_limits<double>::infinity();
  return std::abs(stored / expected - 1);
}

std::array<std::size_t, 4> shape_of(const Grid& grid) {
  return {grid.theta_i.size(), grid.phi_i.size(), grid.theta_s.size(), grid.phi_s.size()};
}

std::array<std::size_t, 4> unflattened(std::size_t flat, const std::array<std::size_t, 4>& shape) {
  std::array<std::size_t, 4> index;
  for (std::size_t k = 4; k-- > 0;) {
    index[k] = flat % shape[k];
    flat /= shape[k];
  }
  return index;
}

std::size_t flattened(const std::array<std::size_t, 4>& index, const std::array<std::size_t, 4>& shape) {
  std::size_t flat = 0;
  for (std::size_t k = 0; k < 4; ++k) flat = flat * shape[k] + index[k];
  return flat;
}

// Flat indices of one brdf and band, in order: the edges of the grid's box, random nodes, and rows.
std::vector<std::size_t> selected(const Grid& grid, const NodeSelection& selection) {
  const auto shape = shape_of(grid);
  std::vector<std::size_t> nodes;
  for (std::size_t axis = 0; axis < 4; ++axis) {
    const std::size_t stride = axis == 0 ? (shape[0] + most_incidences - 1) / most_incidences : 1;
    for (int corner = 0; corner < 16; ++corner) {
      std::array<std::size_t, 4> index;
      for (std::size_t k = 0; k < 4; ++k) index[k] = corner >> k & 1 ? shape[k] - 1 : 0;
      for (index[axis] = 0; index[axis] < shape[axis]; index[axis] += stride)
        nodes.push_back(flattened(index, shape));
    }
  }
  std::mt19937_64 random(20080101);
  std::vector<std::size_t> incidences(random_incidences);
  for (auto& i : incidences) i = random() % shape[0];
  for (std::size_t k = 0; k < selection.random; ++k)
    nodes.push_back(flattened(
        {incidences[k % random_incidences], random() % shape[1], random() % shape[2], random() % shape[3]},
        shape));
  const std::size_t rows = grid.directions() / shape[3];
  const std::size_t stride =
      selection.every_row > 0 ? selection.every_row : std::max<std::size_t>(rows / rows_by_default, 1);
  for (std::size_t row = 0; row < rows; row += stride)
    for (std::size_t k = 0; k < shape[3]; ++k) nodes.push_back(row * shape[3] + k);
  std::sort(nodes.begin(), nodes.end());
  nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
  return nodes;
}

template <class Real>
void widen(std::span<const std::byte> bytes, std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    Real value;
    std::memcpy(&value, bytes.data() + k * sizeof value, sizeof value);
    values[k] = value;
  }
}

// The nodes furthest from the kernels' values.
class Suspects {
 public:
  void add(const Node& node) {
    if (nodes_.size() == most_suspects) {
      if (node.error() <= nodes_.front().error()) return;
      std::pop_heap(nodes_.begin(), nodes_.end(), nearer);
      nodes_.pop_back();
    }
    nodes_.push_back(node);
    std::push_heap(nodes_.begin(), nodes_.end(), nearer);
  }
  std::vector<Node> take() { return std::move(nodes_); }

 private:
  static bool nearer(const Node& a, const Node& b) { return a.error() > b.error(); }
  std::vector<Node> nodes_;
};

// Adds nodes that the reference has evaluated; suspects do not count for the mean.
struct Comparison {
  NodeFindings& findings;
  double tolerance;
  std::size_t over_tolerance = 0;
  double sum = 0;
  std::size_t counted = 0;

  void add(std::span<const Node> nodes, bool suspects) {
    for (const Node& node : nodes) {
      const double error = node.error();
      ++findings.compared;
      if (std::abs(node.expected) < smallest_compared && error == 0) {
        ++findings.negligible;
        continue;
      }
      if (error > tolerance) ++over_tolerance;
      if (!findings.worst || error > findings.max_relative_error) {
        findings.max_relative_error = error;
        findings.worst = node;
      }
      if (suspects) continue;
      sum += error * error;
      ++counted;
    }
    if (counted > 0) findings.rms_relative_error = std::sqrt(sum / static_cast<double>(counted));
  }
};

}  // namespace

double Node::error() const { return relative_error(stored, expected); }

double brdf_at(const reference::Model& model, double theta_i, double theta_s, double phi,
               Polarization polarization) {
  const auto f = model.brdf(theta_i, theta_s, phi);
  return (polarization == Polarization::s   ? f.s
          : polarization == Polarization::p ? f.p
                                            : f.unpolarized())
      .total();
}

void evaluate_nodes(const std::vector<reference::Model>& models, const StoredTable& table,
                    std::span<Node> nodes, const Watch& watch) {
  const auto tasks = pieces({0, nodes.size()}, nodes_per_task);
  parallel_for(
      tasks.size(),
      [&](std::size_t task) {
        for (Node& node : nodes.subspan(tasks[task].begin, tasks[task].size())) {
          const auto& [i, p, s, q] = node.index;
          node.expected =
              brdf_at(models[node.band], table.grid.theta_i[i], table.grid.theta_s[s],
                      table.grid.phi_s[q] - table.grid.phi_i[p], table.polarizations[node.polarization]);
        }
      },
      watch.stop);
}

NodeFindings check_nodes(const Engine& engine, std::vector<Plan>& plans,
                         const std::vector<reference::Model>& models, TableReader& reader,
                         const StoredTable& table, double tolerance, const NodeSelection& selection) {
  const auto shape = shape_of(table.grid);
  const auto chosen = selection.all ? std::vector<std::size_t>{} : selected(table.grid, selection);
  const auto cuts = slabs(table.grid, slab_nodes);
  const bool kernels_decide = engine.working() == Precision::float64;
  NodeFindings findings;
  Comparison comparison{findings, tolerance};
  Suspects suspects;
  std::vector<Node> reference_nodes;
  std::vector<double> stored, kernel;
  std::vector<std::byte> bytes;
  for (std::size_t band = 0; band < plans.size(); ++band)
    for (std::size_t polarization = 0; polarization < table.polarizations.size(); ++polarization)
      for (const Slab& slab : cuts) {
        engine.watch().stop_if_asked();
        const std::size_t nodes = slab.nodes();
        stored.resize(nodes);
        kernel.resize(nodes);
        reader.read(table.polarizations[polarization], band, slab, stored);
        const cl::Buffer samples = engine.buffer(nodes * bytes_of(engine.table()));
        plans[band].tabulate(slab, table.polarizations[polarization], samples);
        bytes.resize(nodes * bytes_of(engine.table()));
        engine.queue().enqueueReadBuffer(samples, CL_TRUE, 0, bytes.size(), bytes.data());
        engine.table() == Precision::float64 ? widen<double>(bytes, kernel) : widen<float>(bytes, kernel);

        const std::size_t first =
            flattened({slab.theta_i.begin, slab.phi_i.begin, slab.theta_s.begin, 0}, shape);
        const auto node_at = [&](std::size_t k) {
          return Node{polarization, band, unflattened(first + k, shape), stored[k], kernel[k]};
        };
        for (std::size_t k = 0; k < nodes; ++k) {
          if (!std::isfinite(stored[k]) || stored[k] < 0) {
            ++(std::isfinite(stored[k]) ? findings.negative : findings.not_finite);
            if (!findings.first_bad) findings.first_bad = node_at(k);
          }
          const double error = stored[k] == kernel[k] ? 0 : relative_error(stored[k], kernel[k]);
          if (kernels_decide && error > tolerance) ++findings.over_tolerance;
          if (error > suspect_share * tolerance) suspects.add(node_at(k));
        }
        findings.nodes += nodes;
        findings.screened += nodes;
        if (selection.all) {
          for (std::size_t k = 0; k < nodes; ++k) reference_nodes.push_back(node_at(k));
          evaluate_nodes(models, table, reference_nodes, engine.watch());
          comparison.add(reference_nodes, false);
          reference_nodes.clear();
        } else {
          for (auto at = std::lower_bound(chosen.begin(), chosen.end(), first);
               at != chosen.end() && *at < first + nodes; ++at)
            reference_nodes.push_back(node_at(*at - first));
        }
      }
  evaluate_nodes(models, table, reference_nodes, engine.watch());
  comparison.add(reference_nodes, false);
  auto doubtful = suspects.take();
  if (!selection.all) {
    evaluate_nodes(models, table, doubtful, engine.watch());
    comparison.add(doubtful, true);
  }
  if (!kernels_decide) findings.over_tolerance = comparison.over_tolerance;
  return findings;
}

}  // namespace brdftab

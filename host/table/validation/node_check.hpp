// The samples of a stored table against the model: every node against the kernels, and many against the
// scalar reference.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "host/base/watch.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/compute/plan.hpp"
#include "host/reference/model.hpp"
#include "host/table/validation/stored_table.hpp"

namespace brdftab {

struct Node {
  std::size_t polarization = 0;  // of StoredTable::polarizations
  std::size_t band = 0;
  std::array<std::size_t, 4> index{};  // theta_i, phi_i, theta_s, phi_s
  double stored = 0;
  double expected = 0;

  /// Relative; infinite where the stored value is not finite, 0 where both are below what is compared.
  double error() const;
};

struct NodeSelection {
  bool all = false;           // every node against the reference
  std::size_t random = 2000;  // seeded
  std::size_t every_row = 0;  // every n-th row of phi_s; 0: so that about 64 rows are compared
};

struct NodeFindings {
  std::size_t nodes = 0;       // of the table
  std::size_t screened = 0;    // compared with the kernels
  std::size_t compared = 0;    // with the reference
  std::size_t negligible = 0;  // of those, both values below smallest_compared
  double max_relative_error = 0;
  double rms_relative_error = 0;
  std::optional<Node> worst;
  std::size_t over_tolerance = 0;  // nodes, by the kernels or by the reference
  std::size_t not_finite = 0;
  std::size_t negative = 0;
  std::optional<Node> first_bad;  // not finite or negative
};

/// `plans` and `models`: one for each band of the table. Reads every sample once.
NodeFindings check_nodes(const Engine& engine, std::vector<Plan>& plans,
                         const std::vector<reference::Model>& models, TableReader& reader,
                         const StoredTable& table, double tolerance, const NodeSelection& selection);

/// f of nodes by the scalar reference, in several threads; sets Node::expected.
void evaluate_nodes(const std::vector<reference::Model>& models, const StoredTable& table,
                    std::span<Node> nodes, const Watch& watch);

/// Of a node, by its polarisation.
double brdf_at(const reference::Model& model, double theta_i, double theta_s, double phi,
               Polarization polarization);

}  // namespace brdftab

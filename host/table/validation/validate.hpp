// A table file against the scalar reference: what `validate` finds.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/table/energy.hpp"
#include "host/table/validation/interpolation.hpp"
#include "host/table/validation/node_check.hpp"

namespace brdftab {

struct ValidateOptions {
  NodeSelection nodes;
  /// Relative; without it, what the file promises.
  std::optional<double> tolerance;
};

/// Stored N or DHR against the model's.
struct IntegralFindings {
  std::size_t compared = 0;  // with the reference; all are compared with the kernels
  double max_relative_error = 0;
  double theta_i = 0;  // degrees, of the maximum
  std::string variable;
};

struct Validation {
  double tolerance = 0;
  NodeFindings nodes;
  IntegralFindings normalization;
  IntegralFindings dhr;
  Reciprocity reciprocity;  // over pairs of the table's own nodes
  double largest_dhr = 0;
  double largest_dhr_theta_i = 0;  // degrees
  std::vector<std::string> energy_warnings;
  InterpolationErrors interpolation;
  /// What is wrong with the table, each in one line; none: it is good.
  std::vector<std::string> faults;
};

Validation validate(const Engine& engine, TableReader& reader, const StoredTable& table,
                    const ValidateOptions& options);

/// A node's angles, wavelength and polarisation in words.
std::string describe(const StoredTable& table, const Node& node);

}  // namespace brdftab

// What a user of a table gets between its nodes: linear interpolation against the model, at the centres of
// cells.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/table/validation/stored_table.hpp"

namespace brdftab {

/// A direction of the table, in degrees, and what was found there, in 1/sr.
struct InterpolationPoint {
  std::array<double, 4> angles{};  // theta_i, phi_i, theta_s, phi_s
  std::optional<double> wavelength_nm;
  Polarization polarization = Polarization::unpolarized;
  double interpolated = 0;
  double model = 0;
};

/// |interpolated - f| / max(f, floor x peak of the slice).
struct InterpolationError {
  std::size_t points = 0;
  double maximum = 0;
  double percentile_95 = 0;
  double median = 0;
  InterpolationPoint worst;
};

struct InterpolationKind {
  InterpolationError linear;       // in f
  InterpolationError logarithmic;  // in ln f, where every corner of the cell is above 0
};

struct InterpolationErrors {
  std::size_t cells = 0;  // of the table
  double floor = 0;
  /// At the centres of cells: along all axes that have more than one node.
  InterpolationKind centre;
  /// Half way between two nodes of one axis, at nodes of the others: which axis is too coarse.
  std::array<InterpolationKind, 4> along;
};

/// Measures at most about `most_points` cells: all, or some by a fixed seed; at most 24 theta_i, which each
/// cost an integral. `floor` is a share of the peak of the cell's slices, 0 for errors relative to f itself.
InterpolationErrors interpolation_errors(const Engine& engine, TableReader& reader, const StoredTable& table,
                                         double floor, std::size_t most_points = 300'000);

/// Reorders errors; `maximum` and `worst` are the caller's.
void set_percentiles(InterpolationError& error, std::vector<double>& errors);

}  // namespace brdftab

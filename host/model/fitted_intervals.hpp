// What a material file that `fit` wrote says of its parameters' uncertainty, in comments beside them.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/material.hpp"

namespace brdftab {

struct FittedInterval {
  double low, high;
  /// Whether the data limit it, and not the bounds of the fit.
  bool is_closed;
  /// The comment whole: interval, bounds and flags.
  std::string remark;
};

/// In the order of parameter_table; none where a parameter was not fitted or has no interval.
using FittedIntervals = std::array<std::optional<FittedInterval>, parameter_table.size()>;

/// By band. A band that does not give a parameter has that of [parameters].
std::vector<FittedIntervals> fitted_intervals(const Material& material);

/// What `fit` says of the statistics as a whole: its `# intervals by` line; empty where the file is not of a
/// fit.
std::string fit_statistics(const Material& material);

}  // namespace brdftab

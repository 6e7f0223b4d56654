// A parameter that a fit frees, and the variable that the solver sees instead of it.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "host/model/parameters.hpp"

namespace brdftab {

/// What the user says about one parameter.
struct ParameterChoice {
  std::optional<double> fixed;
  double minimum;
  double maximum;
};

/// Of the fourteen, in the order of parameter_table; free within the table's ranges.
std::vector<ParameterChoice> default_choices();

/// Applies `--fix NAME=VALUE` and `--bounds NAME=LOW:HIGH`. Throws BadInput that names the option.
void fix_parameter(std::vector<ParameterChoice>& choices, const std::string& text);
void bound_parameter(std::vector<ParameterChoice>& choices, const std::string& text);

/// Its solver's variable is ln x where x > 0, and asinh(x/scale) where x may be 0: linear below the scale,
/// logarithmic above.
struct FitVariable {
  std::size_t parameter;
  /// Bands that share it.
  std::vector<std::size_t> bands;
  double minimum;
  double maximum;

  const ParameterRow& row() const { return parameter_table[parameter]; }
  double to_solver(double value) const;
  double from_solver(double u) const;
  /// dx/du
  double slope(double u) const;
  bool at_minimum(double value) const;
  bool at_maximum(double value) const;

 private:
  double scale() const;
};

}  // namespace brdftab

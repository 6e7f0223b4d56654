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

/// In the order of parameter_table: every parameter is free within the table's range.
std::vector<ParameterChoice> default_choices();

/// Applies a `fix`, NAME=VALUE, and a `bounds`, NAME=LOW:HIGH. Throws BadInput that names the setting.
void fix_parameter(std::vector<ParameterChoice>& choices, const std::string& text);
void bound_parameter(std::vector<ParameterChoice>& choices, const std::string& text);

/// The solver's variable is ln x or asinh(x/scale), as the parameter's row has it.
struct FitVariable {
  std::size_t parameter;
  /// The bands that share it.
  std::vector<std::size_t> bands;
  double minimum;
  double maximum;

  const ParameterRow& row() const { return parameter_table[parameter]; }
  double to_solver(double value) const;
  double from_solver(double u) const;
  /// The derivative dx/du.
  double slope(double u) const;
  bool at_minimum(double value) const;
  bool at_maximum(double value) const;
};

}  // namespace brdftab

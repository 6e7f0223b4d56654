#include "host/fit/fit_variable.hpp"

#include <algorithm>
#include <array>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

// Where a parameter that may be 0 begins to matter; 0: its variable is the logarithm.
constexpr std::array<double, 14> scales{0, 0.05, 1e-3, 0, 1e-3, 0, 1e-3, 0, 0.02, 0.02, 0.1, 0.02, 0, 0.5};

struct Assignment {
  std::size_t parameter;
  std::string value;
};

Assignment assignment(const std::string& option, const std::string& text) {
  const auto equals = text.find('=');
  const std::string name(trimmed(std::string_view(text).substr(0, equals)));
  const auto row = std::find_if(parameter_table.begin(), parameter_table.end(),
                                [&](const auto& r) { return r.name == name; });
  if (equals == std::string::npos || row == parameter_table.end())
    throw BadInput("{} {}: must be PARAMETER=..., with a parameter that `brdftab parameters` lists", option,
                   excerpt(text));
  return {static_cast<std::size_t>(row - parameter_table.begin()), text.substr(equals + 1)};
}

double number(const std::string& option, const std::string& text, std::string_view value,
              const ParameterRow& row) {
  const auto parsed = parse_number(value);
  if (!parsed || !(*parsed >= row.minimum && *parsed <= row.maximum))
    throw BadInput("{} {}: {} must be a number from {} to {}", option, excerpt(text), row.name, row.minimum,
                   row.maximum);
  return *parsed;
}

}  // namespace

std::vector<ParameterChoice> default_choices() {
  std::vector<ParameterChoice> choices;
  for (const auto& row : parameter_table) choices.push_back({std::nullopt, row.minimum, row.maximum});
  return choices;
}

void fix_parameter(std::vector<ParameterChoice>& choices, const std::string& text) {
  const auto [parameter, value] = assignment("--fix", text);
  choices[parameter].fixed = number("--fix", text, value, parameter_table[parameter]);
}

void bound_parameter(std::vector<ParameterChoice>& choices, const std::string& text) {
  const auto [parameter, value] = assignment("--bounds", text);
  const auto colon = value.find(':');
  if (colon == std::string::npos) throw BadInput("--bounds {}: must be PARAMETER=LOW:HIGH", excerpt(text));
  const ParameterRow& row = parameter_table[parameter];
  auto& choice = choices[parameter];
  choice.minimum = number("--bounds", text, std::string_view(value).substr(0, colon), row);
  choice.maximum = number("--bounds", text, std::string_view(value).substr(colon + 1), row);
  if (!(choice.minimum < choice.maximum))
    throw BadInput("--bounds {}: LOW must be below HIGH", excerpt(text));
}

double FitVariable::scale() const { return scales[parameter]; }

double FitVariable::to_solver(double value) const {
  return scale() > 0 ? std::asinh(value / scale()) : std::log(value);
}

double FitVariable::from_solver(double u) const {
  return std::clamp(scale() > 0 ? scale() * std::sinh(u) : std::exp(u), minimum, maximum);
}

double FitVariable::slope(double u) const { return scale() > 0 ? scale() * std::cosh(u) : std::exp(u); }

bool FitVariable::at_minimum(double value) const { return to_solver(value) - to_solver(minimum) < 1e-4; }
bool FitVariable::at_maximum(double value) const { return to_solver(maximum) - to_solver(value) < 1e-4; }

}  // namespace brdftab

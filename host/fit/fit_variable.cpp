#include "host/fit/fit_variable.hpp"

#include <algorithm>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

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
    throw BadInput(GivenValue{option, excerpt(text)},
                   "must be PARAMETER=..., with a parameter that `brdftab parameters` lists");
  return {static_cast<std::size_t>(row - parameter_table.begin()), text.substr(equals + 1)};
}

double number(const std::string& option, const std::string& text, std::string_view value,
              const ParameterRow& row) {
  const auto parsed = parse_number(value);
  if (!parsed || !(*parsed >= row.minimum && *parsed <= row.maximum))
    throw BadInput(GivenValue{option, excerpt(text)}, "{} must be a number from {} to {}", row.name,
                   row.minimum, row.maximum);
  return *parsed;
}

}  // namespace

std::vector<ParameterChoice> default_choices() {
  std::vector<ParameterChoice> choices;
  for (const auto& row : parameter_table) choices.push_back({std::nullopt, row.minimum, row.maximum});
  return choices;
}

void fix_parameter(std::vector<ParameterChoice>& choices, const std::string& text) {
  const auto [parameter, value] = assignment("fix", text);
  choices[parameter].fixed = number("fix", text, value, parameter_table[parameter]);
}

void bound_parameter(std::vector<ParameterChoice>& choices, const std::string& text) {
  const auto [parameter, value] = assignment("bounds", text);
  const auto colon = value.find(':');
  if (colon == std::string::npos)
    throw BadInput(GivenValue{"bounds", excerpt(text)}, "must be PARAMETER=LOW:HIGH");
  const ParameterRow& row = parameter_table[parameter];
  auto& choice = choices[parameter];
  choice.minimum = number("bounds", text, std::string_view(value).substr(0, colon), row);
  choice.maximum = number("bounds", text, std::string_view(value).substr(colon + 1), row);
  if (!(choice.minimum < choice.maximum))
    throw BadInput(GivenValue{"bounds", excerpt(text)}, "LOW must be below HIGH");
}

double FitVariable::to_solver(double value) const {
  const double scale = row().scale;
  return scale > 0 ? std::asinh(value / scale) : std::log(value);
}

double FitVariable::from_solver(double u) const {
  const double scale = row().scale;
  return std::clamp(scale > 0 ? scale * std::sinh(u) : std::exp(u), minimum, maximum);
}

double FitVariable::slope(double u) const {
  const double scale = row().scale;
  return scale > 0 ? scale * std::cosh(u) : std::exp(u);
}

bool FitVariable::at_minimum(double value) const { return to_solver(value) - to_solver(minimum) < 1e-4; }
bool FitVariable::at_maximum(double value) const { return to_solver(maximum) - to_solver(value) < 1e-4; }

}  // namespace brdftab

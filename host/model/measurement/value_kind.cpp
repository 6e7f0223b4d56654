#include "host/model/measurement/value_kind.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdftab {
namespace {

constexpr double per_decibel = std::numbers::ln10 / 10;

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

}  // namespace

std::optional<ValueKind> parse_value_kind(std::string_view name) {
  const auto row = std::find_if(value_kind_table.begin(), value_kind_table.end(),
                                [&](const auto& r) { return r.name == name; });
  return row == value_kind_table.end() ? std::nullopt : std::optional(row->kind);
}

double brdf_of(ValueKind kind, double value, double theta_s) {
  switch (kind) {
    case ValueKind::log10:
      return std::pow(10, value);
    case ValueKind::ln:
      return std::exp(value);
    case ValueKind::decibel:
      return std::pow(10, value / 10);
    default:
      return value * slope_of_brdf(kind, 0, theta_s);
  }
}

double slope_of_brdf(ValueKind kind, double brdf, double theta_s) {
  switch (kind) {
    case ValueKind::brdf:
      return 1;
    case ValueKind::pi_f:
      return std::numbers::inv_pi;
    case ValueKind::percent:
      return std::numbers::inv_pi / 100;
    case ValueKind::log10:
      return brdf * std::numbers::ln10;
    case ValueKind::ln:
      return brdf;
    case ValueKind::decibel:
      return brdf * per_decibel;
    case ValueKind::cosine_weighted:
      return 1 / cosine(theta_s);
  }
  return 1;
}

}  // namespace brdftab

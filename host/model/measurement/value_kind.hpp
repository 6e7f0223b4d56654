// What the values of a measured file are, and f in 1/sr from them.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace brdftab {

enum class ValueKind { brdf, pi_f, percent, log10, ln, decibel, cosine_weighted };

struct ValueKindRow {
  ValueKind kind;
  std::string_view name;
  std::string_view meaning;
};

inline constexpr std::array<ValueKindRow, 7> value_kind_table{{
    {ValueKind::brdf, "brdf", "f in 1/sr"},
    {ValueKind::pi_f, "pi-f", "reflectance factor, 1 of a perfect diffuser"},
    {ValueKind::percent, "percent", "reflectance factor in percent, 100 of a perfect diffuser"},
    {ValueKind::log10, "log10", "log10 f"},
    {ValueKind::ln, "ln", "ln f"},
    {ValueKind::decibel, "db", "10 log10 f"},
    {ValueKind::cosine_weighted, "cosine-weighted", "f cos theta_s"},
}};

/// Finds a kind by its name; none where the table has no such name.
std::optional<ValueKind> parse_value_kind(std::string_view name);

/// Gives f in 1/sr from a value measured at `theta_s` degrees, below 90.
double brdf_of(ValueKind kind, double value, double theta_s);
/// Gives df/dvalue at that f, which turns a standard uncertainty of the value into one of f.
double slope_of_brdf(ValueKind kind, double brdf, double theta_s);

}  // namespace brdftab

// The width of a number: in a table, or in a kernel's arithmetic.
#pragma once

#include <cstddef>
#include <string_view>

namespace brdftab {

enum class Precision { float32, float64 };

constexpr std::size_t bytes_of(Precision precision) { return precision == Precision::float64 ? 8 : 4; }
constexpr std::string_view name_of(Precision precision) {
  return precision == Precision::float64 ? "float64" : "float32";
}

/// The largest relative error that a table promises of a sample.
constexpr double promised_error(Precision precision) {
  return precision == Precision::float64 ? 1e-12 : 1e-6;
}

}  // namespace brdftab

#include "host/model/measurement/wavelength_unit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

// This is far below what any spectrometer resolves, and above the rounding of float32.
constexpr double resolution = 1e-6;

// Rounds to 13 digits: 0.45 um are 450 nm, without the last bits of a multiplication.
double rounded(double nm) {
  const double decade = std::pow(10, 12 - std::floor(std::log10(nm)));
  return std::round(nm * decade) / decade;
}

}  // namespace

std::optional<WavelengthUnit> parse_wavelength_unit(std::string_view name) {
  const auto row = std::find_if(wavelength_units.begin(), wavelength_units.end(),
                                [&](const auto& u) { return u.name == name; });
  return row == wavelength_units.end() ? std::nullopt : std::optional(*row);
}

std::optional<NamedWavelength> parse_wavelength(std::string_view text, const WavelengthUnit& unit) {
  // Both the micro sign and the Greek letter stand for it; "m" ends the others and comes last.
  constexpr std::array<std::pair<std::string_view, double>, 5> suffixes{
      {{"nm", 1}, {"um", 1e3}, {"\u00b5m", 1e3}, {"\u03bcm", 1e3}, {"m", 1e9}}};
  text = trimmed(text);
  double factor = unit.nm;
  for (const auto& [suffix, nm] : suffixes)
    if (text.ends_with(suffix)) {
      text.remove_suffix(suffix.size());
      factor = nm;
      break;
    }
  const auto value = parse_number(text);
  if (!value || !std::isfinite(*value) || !(*value > 0)) return std::nullopt;
  return NamedWavelength{.nm = factor == 1 ? *value : rounded(*value * factor), .nm_per_unit = factor};
}

bool is_same_wavelength(double nm, double other_nm) {
  return std::abs(nm - other_nm) <= resolution * std::max(nm, other_nm);
}

}  // namespace brdftab

// Files name wavelengths by a number, with or without its unit.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace brdftab {

struct WavelengthUnit {
  std::string_view name;
  double nm;
};

/// "nm" comes first.
inline constexpr std::array<WavelengthUnit, 3> wavelength_units{{{"nm", 1}, {"um", 1e3}, {"m", 1e9}}};

/// Light goes from vacuum ultraviolet to far infrared, nm: beyond it a number is more likely in another unit.
inline constexpr double least_plausible_nm = 100;
inline constexpr double largest_plausible_nm = 100'000;
inline bool is_plausible_wavelength(double nm) {
  return nm >= least_plausible_nm && nm <= largest_plausible_nm;
}

/// Finds a unit by its name; none where the table has no such name.
std::optional<WavelengthUnit> parse_wavelength_unit(std::string_view name);

struct NamedWavelength {
  double nm;
  /// What the text's number was multiplied by.
  double nm_per_unit;
};

/// Reads "450", "0.45um", "450 nm", "4.5e-7m" (with a micro sign, too); a number alone is in `unit`. None
/// where the text is no wavelength above 0.
std::optional<NamedWavelength> parse_wavelength(std::string_view text,
                                                const WavelengthUnit& unit = wavelength_units[0]);

/// Says whether only decimals in other units, or float32, tell the two apart.
bool is_same_wavelength(double nm, double other_nm);

}  // namespace brdftab

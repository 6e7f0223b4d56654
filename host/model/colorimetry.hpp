// Bands to colours, for formats that hold three channels: the CIE 1931 2-degree observer, linear Rec. 709
// (sRGB) primaries.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

namespace brdftab {

/// The light under which colours are seen.
enum class Illuminant { d65, equal_energy };

/// As options and files name them.
inline constexpr std::array<std::string_view, 2> illuminant_names{"D65", "E"};

constexpr std::string_view name_of(Illuminant illuminant) {
  return illuminant_names[static_cast<std::size_t>(illuminant)];
}

/// How much of each band's f a channel takes, [channel][band].
using ChannelWeights = std::array<std::vector<double>, 3>;

/// X, Y and Z from bands at these wavelengths, nm, that increase; f between bands is linear in the
/// wavelength, and constant beyond them. Each is relative to that of the perfect white, so that f constant
/// over wavelengths gives X = Y = Z = f under either illuminant, and Y is the luminous reflectance. No
/// wavelength: one band, grey. Sums over 380:780:5 nm.
ChannelWeights xyz_weights(const std::vector<double>& wavelengths_nm, Illuminant illuminant);

/// Linear sRGB in the same way. The illuminant's white is brought to that of sRGB by Bradford adaptation, so
/// that f constant over wavelengths gives three equal channels under either illuminant. Saturated colours may
/// have a channel below 0.
ChannelWeights rgb_weights(const std::vector<double>& wavelengths_nm, Illuminant illuminant);

/// What files say of their channels.
std::string_view rgb_convention(Illuminant illuminant);

/// Channels [3][sample] from [band][sample].
std::vector<std::vector<double>> weighted(const ChannelWeights& weights,
                                          const std::vector<std::vector<double>>& by_band);

}  // namespace brdftab

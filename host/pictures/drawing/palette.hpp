// The colours of pictures. People who see no red or green tell them apart too, on a white page and a dark
// one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace brdftab::drawing {

struct Rgb {
  std::uint8_t red, green, blue;

  /// The colour written as `#rrggbb`.
  std::string hex() const;
};

/// A colour for light pages and one that takes its place on dark pages.
struct Ink {
  Rgb light;
  Rgb dark;
};

namespace inks {
inline constexpr Ink page{{255, 255, 255}, {20, 23, 28}};
inline constexpr Ink text{{26, 26, 26}, {232, 232, 232}};
inline constexpr Ink faint_text{{95, 95, 95}, {165, 168, 172}};
inline constexpr Ink frame{{70, 70, 70}, {165, 168, 172}};
inline constexpr Ink grid{{224, 224, 224}, {52, 57, 64}};
}  // namespace inks

/// The ink of the k-th kind of thing, such as a lobe. The eight colours are those of Okabe and Ito; they
/// repeat from the ninth kind on, where `dash_of` tells lines apart.
Ink category_ink(std::size_t k);

/// The dash array in SVG for the k-th kind of thing. It is empty for a whole line.
std::string dash_of(std::size_t k);

/// The ink of the k-th of `count` steps of one quantity, such as theta_i. The steps follow matplotlib's
/// plasma (CC0) without the end that is too close to the page's colour.
Ink step_ink(std::size_t k, std::size_t count);

/// A scale of colours over [0, 1]. A place beyond takes the colour of the nearer end, and nan that of 0.
class ColourScale {
 public:
  explicit constexpr ColourScale(std::span<const Rgb> stops) : stops_(stops) {}

  Rgb at(double place) const;
  std::span<const Rgb> stops() const { return stops_; }

 private:
  std::span<const Rgb> stops_;
};

/// matplotlib's viridis (CC0), which is perceptually uniform. Its 8-bit colours are met within two steps.
extern const ColourScale viridis;

/// A scale from blue through white, at 1/2, to orange. Both sides have the same lightness.
extern const ColourScale blue_to_orange;

}  // namespace brdftab::drawing

// Colours of pictures: told apart by people who see no red or green, on a white page and on a dark one.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace brdftab {

struct Rgb {
  std::uint8_t red, green, blue;

  /// As `#rrggbb`.
  std::string hex() const;
};

/// A colour on a light page, and in its place on a dark one.
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

/// Kinds of thing, such as lobes: the colours of Okabe and Ito. From the ninth on they repeat, and `dash_of`
/// tells them apart.
Ink category_ink(std::size_t k);

/// A dash array for SVG, empty for a whole line.
std::string dash_of(std::size_t k);

/// Steps of one quantity, such as theta_i: the k-th of `count`, along matplotlib's plasma (CC0), without the
/// end that is too close to the page.
Ink step_ink(std::size_t k, std::size_t count);

/// A scale of colours over [0, 1]; values beyond take the colour of the end, nan that of 0.
class ColourScale {
 public:
  explicit constexpr ColourScale(std::span<const Rgb> stops) : stops_(stops) {}

  Rgb at(double place) const;
  std::span<const Rgb> stops() const { return stops_; }

 private:
  std::span<const Rgb> stops_;
};

/// Perceptually uniform: matplotlib's viridis (CC0), within two steps of 8 bits.
extern const ColourScale viridis;

/// From blue over white, at 1/2, to orange: even in lightness on both sides.
extern const ColourScale blue_to_orange;

}  // namespace brdftab

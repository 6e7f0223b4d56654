#include "host/pictures/drawing/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brdftab::drawing {
namespace {

constexpr std::array<Rgb, 33> viridis_stops{
    {{0x44, 0x01, 0x54}, {0x47, 0x0d, 0x60}, {0x48, 0x18, 0x6a}, {0x48, 0x23, 0x74}, {0x47, 0x2d, 0x7b},
     {0x45, 0x36, 0x81}, {0x42, 0x40, 0x86}, {0x3f, 0x49, 0x89}, {0x3b, 0x52, 0x8b}, {0x37, 0x5a, 0x8d},
     {0x33, 0x63, 0x8d}, {0x2f, 0x6a, 0x8e}, {0x2c, 0x72, 0x8e}, {0x29, 0x7a, 0x8e}, {0x26, 0x81, 0x8e},
     {0x23, 0x89, 0x8e}, {0x21, 0x90, 0x8c}, {0x1f, 0x98, 0x8b}, {0x1f, 0x9f, 0x88}, {0x21, 0xa6, 0x85},
     {0x28, 0xae, 0x80}, {0x31, 0xb5, 0x7b}, {0x3e, 0xbc, 0x74}, {0x4c, 0xc2, 0x6c}, {0x5d, 0xc9, 0x63},
     {0x6e, 0xce, 0x58}, {0x82, 0xd3, 0x4c}, {0x96, 0xd8, 0x3f}, {0xab, 0xdc, 0x32}, {0xc0, 0xdf, 0x24},
     {0xd5, 0xe2, 0x1a}, {0xea, 0xe5, 0x1a}, {0xfd, 0xe7, 0x25}}};
constexpr std::array<Rgb, 17> plasma_stops{{{0x0d, 0x08, 0x87},
                                            {0x31, 0x05, 0x96},
                                            {0x4c, 0x02, 0xa1},
                                            {0x66, 0x00, 0xa7},
                                            {0x7e, 0x03, 0xa8},
                                            {0x95, 0x11, 0xa2},
                                            {0xa9, 0x23, 0x96},
                                            {0xbb, 0x35, 0x87},
                                            {0xcb, 0x47, 0x78},
                                            {0xd9, 0x59, 0x6a},
                                            {0xe6, 0x6c, 0x5c},
                                            {0xf0, 0x7f, 0x4f},
                                            {0xf8, 0x94, 0x41},
                                            {0xfd, 0xab, 0x33},
                                            {0xfd, 0xc3, 0x28},
                                            {0xf9, 0xdd, 0x25},
                                            {0xf0, 0xf9, 0x21}}};
constexpr std::array<Rgb, 17> blue_to_orange_stops{{{0x0b, 0x3c, 0x6f},
                                                    {0x1c, 0x51, 0x89},
                                                    {0x2c, 0x68, 0xa3},
                                                    {0x3b, 0x7f, 0xbe},
                                                    {0x5a, 0x97, 0xd3},
                                                    {0x86, 0xad, 0xdb},
                                                    {0xad, 0xc4, 0xe4},
                                                    {0xd1, 0xdc, 0xec},
                                                    {0xf4, 0xf4, 0xf4},
                                                    {0xf5, 0xd5, 0xc2},
                                                    {0xf0, 0xb6, 0x91},
                                                    {0xe7, 0x97, 0x62},
                                                    {0xdb, 0x79, 0x31},
                                                    {0xc3, 0x5f, 0x13},
                                                    {0xa6, 0x4a, 0x07},
                                                    {0x8a, 0x35, 0x00},
                                                    {0x6f, 0x21, 0x00}}};

constexpr ColourScale plasma{plasma_stops};

constexpr std::array<Ink, 8> categories{{{{0x00, 0x72, 0xb2}, {0x4d, 0xa6, 0xe0}},
                                         {{0xd5, 0x5e, 0x00}, {0xf0, 0x80, 0x30}},
                                         {{0x00, 0x9e, 0x73}, {0x20, 0xc0, 0x95}},
                                         {{0xcc, 0x79, 0xa7}, {0xe0, 0x95, 0xc0}},
                                         {{0xe6, 0x9f, 0x00}, {0xf0, 0xb4, 0x2a}},
                                         {{0x56, 0xb4, 0xe9}, {0x9a, 0xd8, 0xff}},
                                         {{0x00, 0x00, 0x00}, {0xff, 0xff, 0xff}},
                                         {{0x88, 0x88, 0x88}, {0xa0, 0xa0, 0xa0}}}};
constexpr std::array<const char*, 4> dashes{"", "7 3", "2 3", "9 3 2 3"};

std::uint8_t mixed(std::uint8_t from, std::uint8_t to, double share) {
  return static_cast<std::uint8_t>(std::lround(from + (to - from) * share));
}

}  // namespace

const ColourScale viridis{viridis_stops};
const ColourScale blue_to_orange{blue_to_orange_stops};

std::string Rgb::hex() const { return fmt::format("#{:02x}{:02x}{:02x}", red, green, blue); }

Ink category_ink(std::size_t k) { return categories[k % categories.size()]; }

std::string dash_of(std::size_t k) { return dashes[k / categories.size() % dashes.size()]; }

Ink step_ink(std::size_t k, std::size_t count) {
  const double place = count > 1 ? static_cast<double>(k) / static_cast<double>(count - 1) : 0;
  // The dark end of plasma changes slowly, so its steps are made larger there.
  return {plasma.at(0.02 + 0.84 * std::pow(place, 0.8)), plasma.at(0.36 + 0.62 * place)};
}

Rgb ColourScale::at(double place) const {
  const double last = static_cast<double>(stops_.size() - 1);
  const double along = place > 0 ? std::min(place, 1.0) * last : 0;
  const auto k = std::min(static_cast<std::size_t>(along), stops_.size() - 2);
  const double share = along - static_cast<double>(k);
  return {mixed(stops_[k].red, stops_[k + 1].red, share), mixed(stops_[k].green, stops_[k + 1].green, share),
          mixed(stops_[k].blue, stops_[k + 1].blue, share)};
}

}  // namespace brdftab::drawing

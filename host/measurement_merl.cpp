// MERL binary files: f over the half-way and difference angles of Rusinkiewicz, in cells.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "host/error.hpp"
#include "host/measurement_text.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little);

constexpr int cells_h = 90;  // theta_h, quadratic: cell i about (i + 1/2)^2/90 degrees
constexpr int cells_d = 90;  // theta_d, by degree
constexpr int cells_phi = 180;
constexpr std::size_t plane = std::size_t{cells_h} * cells_d * cells_phi;
constexpr std::array<double, 3> channel_scale{1. / 1500, 1.15 / 1500, 1.66 / 1500};

// MERL's own measurements are unreliable beyond.
constexpr int largest_theta = 80;
constexpr int step_i = 10;
constexpr int step_s = 2;

// In plane: f at theta_h and theta_d in degrees, between the centres of cells; negative where one of them is invalid.
// phi_d is 0 or 180 degrees, between the first cell and the last.
double in_plane(const double* values, double theta_h, double theta_d) {
  const double h = std::clamp(std::sqrt(theta_h * cells_h) - 0.5, 0., cells_h - 1.);
  const double d = std::clamp(theta_d - 0.5, 0., cells_d - 1.);
  const int h0 = std::min(static_cast<int>(h), cells_h - 2);
  const int d0 = std::min(static_cast<int>(d), cells_d - 2);
  double sum = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (const int phi : {0, cells_phi - 1}) {
        const double weight = 0.5 * (i ? h - h0 : 1 - (h - h0)) * (j ? d - d0 : 1 - (d - d0));
        const double cell = values[phi + cells_phi * (d0 + j + cells_d * (h0 + i))];
        if (weight > 0 && cell < 0) return -1;
        sum += weight * cell;
      }
  return sum;
}

}  // namespace

Measurement read_merl_measurement(std::istream& in, const std::string& source) {
  std::array<std::int32_t, 3> dimensions{};
  in.read(reinterpret_cast<char*>(dimensions.data()), sizeof(dimensions));
  if (!in || dimensions != std::array<std::int32_t, 3>{cells_h, cells_d, cells_phi})
    throw BadInput("{}: is no MERL file: it must begin with the dimensions 90, 90, 180", source);
  std::vector<double> values(3 * plane);
  in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(values.size() * sizeof(double)));
  if (!in) throw BadInput("{}: has fewer than the {} values of a MERL file", source, values.size());
  Measurement measurement{.source = source, .channels = {"R", "G", "B"}, .samples = {}, .warnings = {}};
  std::size_t invalid = 0;
  for (std::size_t c = 0; c < 3; ++c)
    for (int theta_i = 0; theta_i <= largest_theta; theta_i += step_i)
      for (int theta_s = -largest_theta; theta_s <= largest_theta; theta_s += step_s) {
        // Between the directions to the light, -theta_i, and to the detector, theta_s.
        const double f = channel_scale[c] *
                         in_plane(values.data() + c * plane, std::abs(theta_s - theta_i) / 2., std::abs(theta_s + theta_i) / 2.);
        if (f < 0)
          ++invalid;
        else
          measurement.samples.push_back({.pair = {double(theta_i), double(theta_s), 0, 0}, .brdf = f, .channel = c});
      }
  if (invalid > 0) measurement.warnings.push_back(fmt::format("{} directions are marked invalid: set aside", invalid));
  return measurement;
}

}  // namespace brdftab

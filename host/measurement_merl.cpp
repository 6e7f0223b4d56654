// MERL binary files as measurements: in plane, between the centres of cells.
#include <algorithm>
#include <cmath>

#include "host/error.hpp"
#include "host/measurement_text.hpp"
#include "host/merl_file.hpp"

namespace brdftab {
namespace {

// MERL's own measurements are unreliable beyond.
constexpr int largest_theta = 80;
constexpr int step_i = 10;
constexpr int step_s = 2;

// In plane: f at theta_h and theta_d in degrees, between the centres of cells; negative where one of them is invalid.
// phi_d is 0 or 180 degrees, between the first cell and the last.
double in_plane(const MerlFile& file, int channel, double theta_h, double theta_d) {
  constexpr int cells_h = MerlFile::cells_h, cells_d = MerlFile::cells_d;
  const double h = std::clamp(std::sqrt(theta_h * cells_h) - 0.5, 0., cells_h - 1.);
  const double d = std::clamp(theta_d - 0.5, 0., cells_d - 1.);
  const int h0 = std::min(static_cast<int>(h), cells_h - 2);
  const int d0 = std::min(static_cast<int>(d), cells_d - 2);
  double sum = 0;
  for (int i = 0; i < 2; ++i)
    for (int j = 0; j < 2; ++j)
      for (const int phi : {0, MerlFile::cells_phi - 1}) {
        const double weight = 0.5 * (i ? h - h0 : 1 - (h - h0)) * (j ? d - d0 : 1 - (d - d0));
        const double cell = file.values[MerlFile::index(channel, h0 + i, d0 + j, phi)];
        if (weight > 0 && cell < 0) return -1;
        sum += weight * cell;
      }
  return sum;
}

}  // namespace

Measurement read_merl_measurement(std::istream& in, const std::string& source) {
  const MerlFile file = MerlFile::read(in, source);
  Measurement measurement{.source = source, .channels = {"R", "G", "B"}, .samples = {}, .warnings = {}};
  std::size_t invalid = 0;
  for (int c = 0; c < 3; ++c)
    for (int theta_i = 0; theta_i <= largest_theta; theta_i += step_i)
      for (int theta_s = -largest_theta; theta_s <= largest_theta; theta_s += step_s) {
        // Between the directions to the light, -theta_i, and to the detector, theta_s.
        const double f =
            MerlFile::scale(c) * in_plane(file, c, std::abs(theta_s - theta_i) / 2., std::abs(theta_s + theta_i) / 2.);
        if (f < 0)
          ++invalid;
        else
          measurement.samples.push_back(
              {.pair = {double(theta_i), double(theta_s), 0, 0}, .brdf = f, .channel = static_cast<std::size_t>(c)});
      }
  if (invalid > 0) measurement.warnings.push_back(fmt::format("{} directions are marked invalid: set aside", invalid));
  return measurement;
}

}  // namespace brdftab

#include "host/formats/merl/merl_file.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little);

using Dimensions = std::array<std::int32_t, 3>;
constexpr Dimensions dimensions{MerlFile::cells_h, MerlFile::cells_d, MerlFile::cells_phi};

// Lagrange's polynomials through the four whole numbers about a position give these shares.
struct Stencil {
  int first;
  std::array<double, 4> share;
};

Stencil stencil(double position) {
  const double below = std::floor(position), t = position - below;
  return {static_cast<int>(below) - 1,
          {-t * (t - 1) * (t - 2) / 6, (t + 1) * (t - 1) * (t - 2) / 2, -(t + 1) * t * (t - 2) / 2,
           (t + 1) * t * (t - 1) / 6}};
}

// Below cell 0 lies cell 0 of the other side.
int mirrored(int cell) { return cell < 0 ? -1 - cell : cell; }

}  // namespace

HalfDifference half_difference(const SurfaceVector& to_light, const SurfaceVector& to_viewer) {
  const SurfaceVector h = (to_light + to_viewer).normalized();
  const double sine = std::hypot(h.x, h.y);
  const double c = sine > 0 ? h.x / sine : 1, s = sine > 0 ? h.y / sine : 0;
  // The light is turned by -phi_h about the normal and then by -theta_h about y.
  const double x = c * to_light.x + s * to_light.y;
  const SurfaceVector d{x * h.z - to_light.z * sine, c * to_light.y - s * to_light.x,
                        x * sine + to_light.z * h.z};
  return {h.theta(), d.theta(), d.phi()};
}

double MerlFile::scale(int channel) {
  constexpr std::array<double, 3> scales{1. / 1500, 1.15 / 1500, 1.66 / 1500};
  return scales[static_cast<std::size_t>(channel)];
}

double MerlFile::between_centers(int channel, const HalfDifference& at) const {
  const Stencil h = stencil(std::sqrt(at.theta_h * cells_h) - 0.5), d = stencil(at.theta_d - 0.5),
                phi = stencil(at.phi_d - 0.5);
  double ln_f = 0;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      for (int k = 0; k < 4; ++k) {
        const int row = mirrored(h.first + i), column = mirrored(d.first + j);
        if (row >= cells_h || column >= cells_d) return std::numeric_limits<double>::quiet_NaN();
        const double value =
            values[index(channel, row, column, ((phi.first + k) % cells_phi + cells_phi) % cells_phi)];
        if (!(value > 0)) return std::numeric_limits<double>::quiet_NaN();
        ln_f += h.share[i] * d.share[j] * phi.share[k] * std::log(value);
      }
  return scale(channel) * std::exp(ln_f);
}

MerlFile MerlFile::read(std::istream& in, const std::string& source) {
  Dimensions found{};
  in.read(reinterpret_cast<char*>(found.data()), sizeof(found));
  if (!in || found != dimensions)
    throw BadInput("{}: is no MERL file: it must begin with the dimensions 90, 90, 180", source);
  MerlFile file;
  in.read(reinterpret_cast<char*>(file.values.data()),
          static_cast<std::streamsize>(file.values.size() * sizeof(double)));
  if (!in) throw BadInput("{}: has fewer than the {} values of a MERL file", source, file.values.size());
  return file;
}

std::string MerlFile::bytes() const {
  std::string result(reinterpret_cast<const char*>(dimensions.data()), sizeof(dimensions));
  return result.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

}  // namespace brdftab

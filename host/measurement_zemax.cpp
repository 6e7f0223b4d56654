// Zemax OpticStudio's tabular BSDF as a measurement.
#include <cmath>

#include "host/error.hpp"
#include "host/measurement_text.hpp"
#include "host/surface_vector.hpp"
#include "host/zemax_file.hpp"

namespace brdftab {
namespace {

double rounded(double degrees) { return std::round(degrees * 1e6) / 1e6; }

}  // namespace

Measurement read_zemax_measurement(std::istream& in, const std::string& source) {
  const ZemaxFile file = ZemaxFile::read(in, source);
  Measurement measurement;
  measurement.source = source;
  std::size_t below_horizon = 0;
  for (const ZemaxBlock& block : file.blocks) {
    const std::size_t channel = measurement.channels.size();
    measurement.channels.push_back(block.content == "Monochrome" ? "" : block.content);
    auto value = block.values.begin();
    for (std::size_t rotation = 0; rotation < file.rotation.size(); ++rotation)
      for (const double theta_i : file.incidence)
        for (const double azimuth : file.azimuth)
          for (const double radial : file.radial) {
            const SurfaceVector at = about_specular(theta_i, radial, azimuth);
            const double brdf = *value++, theta_s = rounded(at.theta());
            if (theta_s < 90)
              measurement.samples.push_back({.pair = {theta_i, theta_s, rounded(at.phi()), 0}, .brdf = brdf, .channel = channel});
            else
              below_horizon += brdf != 0;
          }
  }
  if (below_horizon > 0)
    measurement.warnings.push_back(fmt::format("{} values above 0 lie below the horizon: set aside", below_horizon));
  if (file.rotation.size() > 1)
    measurement.warnings.push_back(
        fmt::format("{} rotations of the sample are taken as one isotropic surface", file.rotation.size()));
  return measurement;
}

}  // namespace brdftab

#include "host/formats/zemax/zemax_measurement.hpp"

#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/zemax/zemax_file.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

double rounded(double degrees) { return std::round(degrees * 1e6) / 1e6; }

// The format gives the one direction at radial 0 a value at every azimuth, and that of azimuth 0 again at 360
// degrees.
bool repeats(const ZemaxFile& file, std::span<const double> of_incidence, std::size_t azimuth,
             std::size_t radial) {
  const double turn = file.azimuth[azimuth] - file.azimuth[0];
  return (turn == 360 || (turn > 0 && file.radial[radial] == 0)) &&
         of_incidence[azimuth * file.radial.size() + radial] == of_incidence[radial];
}

void take_angles(ZemaxFile& file, const AngleUnit& unit, const std::string& source) {
  for (auto* axis : {&file.incidence, &file.radial})
    for (double& angle : *axis) angle = in_degrees(angle, unit.theta);
  for (auto* axis : {&file.rotation, &file.azimuth})
    for (double& angle : *axis) angle = in_degrees(angle, unit.phi);
  for (const double theta_i : file.incidence)
    if (!(theta_i < 90))
      throw BadInput(
          "{}: AngleOfIncidence {} degrees: must be below 90; `angles` {} takes the file's angles so", source,
          shortest(theta_i), unit.name);
}

}  // namespace

Measurement read_zemax_measurement(std::istream& in, const std::string& source,
                                   const MeasurementOptions& options) {
  ZemaxFile file = ZemaxFile::read(in, source);
  Measurement measurement;
  measurement.source = source;
  if (options.angles)
    take_angles(file, *options.angles, source);
  else if (std::string doubt = doubt_of_degrees(file.incidence, file.radial, file.azimuth, std::numbers::pi);
           !doubt.empty())
    measurement.warnings.push_back(std::move(doubt));
  std::size_t below_horizon = 0, repeated = 0;
  for (const ZemaxBlock& block : file.blocks) {
    const std::size_t channel = measurement.channels.size();
    measurement.channels.push_back(block.content == "Monochrome" ? "" : block.content);
    std::span<const double> rest(block.values);
    for (std::size_t rotation = 0; rotation < file.rotation.size(); ++rotation)
      for (const double theta_i : file.incidence) {
        const auto values = rest.first(file.azimuth.size() * file.radial.size());
        rest = rest.subspan(values.size());
        for (std::size_t a = 0; a < file.azimuth.size(); ++a)
          for (std::size_t r = 0; r < file.radial.size(); ++r) {
            const SurfaceVector at = about_specular(theta_i, file.radial[r], file.azimuth[a]);
            const double brdf = values[a * file.radial.size() + r], theta_s = rounded(at.theta());
            if (!(theta_s < 90))
              below_horizon += brdf != 0;
            else if (repeats(file, values, a, r))
              ++repeated;
            else
              measurement.samples.push_back(
                  {.pair = {theta_i, theta_s, rounded(at.phi()), 0}, .brdf = brdf, .channel = channel});
          }
      }
  }
  if (repeated > 0)
    measurement.warnings.push_back(fmt::format(
        "{} values repeat that of another azimuth in the same direction, as the format has it: set aside",
        repeated));
  if (below_horizon > 0)
    measurement.warnings.push_back(
        fmt::format("{} values above 0 lie below the horizon: set aside", below_horizon));
  if (file.rotation.size() > 1)
    measurement.warnings.push_back(
        fmt::format("{} rotations of the sample are taken as one isotropic surface", file.rotation.size()));
  return measurement;
}

}  // namespace brdftab

#include "host/formats/export/export_reader.hpp"

#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {

std::vector<std::vector<double>> in_channels(ExportChannels channels, const ExportModel& source,
                                             const std::vector<std::vector<double>>& by_band) {
  if (channels == ExportChannels::rgb) return source.rgb(by_band);
  if (channels == ExportChannels::xyz) return source.xyz(by_band);
  return by_band;
}

void check_channels(std::size_t file, std::size_t material) {
  if (file != material) throw BadInput("the file has {} channels, and its material {}", file, material);
}

std::string channel_name(ExportChannels channels, const ExportModel& source, std::size_t channel) {
  if (channels != ExportChannels::bands)
    return std::string(1, (channels == ExportChannels::rgb ? "RGB" : "XYZ")[channel]);
  const auto wavelengths = source.wavelengths_nm();
  return channel < wavelengths.size() ? shortest(wavelengths[channel]) + " nm" : "f";
}

std::string angles_text(const Directions& directions, std::size_t k) {
  return fmt::format("theta_i = {:.6g}, theta_s = {:.6g}, phi = {:.6g} degrees", directions.theta_i[k],
                     directions.theta_s[k], std::remainder(directions.phi[k], 360));
}

}  // namespace brdftab

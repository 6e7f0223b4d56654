#include "host/formats/format.hpp"

#include <cerrno>
#include <cmath>
#include <fstream>
#include <system_error>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/registry.hpp"

namespace brdftab {
namespace {

constexpr std::size_t beginning_bytes = 4096;

constexpr std::unique_ptr<ExportFormat> (*format_makers[])() = {
    make_astm_format,          //
    make_bird_format,          //
    make_csv_format,           //
    make_eradiate_format,      //
    make_merl_format,          //
    make_openmaterial_format,  //
    make_radiance_format,      //
    make_rgl_format,           //
    make_ssdd_format,          //
    make_zemax_format,         //
};

}  // namespace

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

ExportFormats export_formats() {
  ExportFormats formats;
  for (const auto make : format_makers) formats.push_back(make());
  return formats;
}

const ExportFormat* recognised_format(const ExportFormats& formats, const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw FileError("{}: does not exist", file.string());
  std::string beginning(beginning_bytes, '\0');
  if (std::filesystem::is_directory(file, error)) {
    beginning.clear();
  } else {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw FileError("{}: cannot be read: {}", file.string(), std::generic_category().message(errno));
    in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    beginning.resize(static_cast<std::size_t>(in.gcount()));
  }
  for (const auto& format : formats)
    if (format->recognises(file, beginning)) return format.get();
  return nullptr;
}

Material read_material_file(const std::filesystem::path& file) {
  std::error_code error;
  if (file != "-" && std::filesystem::is_regular_file(file, error)) {
    const ExportFormats formats = export_formats();
    if (const ExportFormat* format = recognised_format(formats, file))
      throw BadInput("{}: is a simulator's file ({}); what is taken is a material or a table (hdf5, exr)",
                     file.string(), format->traits().name);
  }
  return Material::read(file);
}

}  // namespace brdftab

#include "host/formats/read_measurement.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <iostream>
#include <system_error>

#include "host/base/error.hpp"
#include "host/formats/merl/merl_measurement.hpp"
#include "host/formats/text/alta_astm_measurement.hpp"
#include "host/formats/text/csv_measurement.hpp"
#include "host/formats/zemax/zemax_measurement.hpp"
#include "host/model/measurement/measured_light.hpp"

namespace brdftab {
namespace {

struct Reader {
  std::string_view format;
  std::array<std::string_view, 2> extensions;
  Measurement (*read)(std::istream&, const std::string&, const MeasurementOptions&);
  /// Grids are written in it too, with every azimuth at the normal and at 0 and 360 degrees.
  bool lists_grids = false;
};

constexpr std::array<Reader, 5> readers{{{"csv", {".csv", ".csv"}, read_csv_measurement},
                                         {"alta", {".alta", ".dat"}, read_alta_measurement, true},
                                         {"astm", {".astm", ".astm"}, read_astm_measurement, true},
                                         {"zemax", {".bsdf", ".bsdf"}, read_zemax_measurement},
                                         {"merl", {".binary", ".binary"}, read_merl_measurement}}};

std::string format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (file == "-") return "csv";
  for (const Reader& reader : readers)
    if (std::find(reader.extensions.begin(), reader.extensions.end(), extension) != reader.extensions.end())
      return std::string(reader.format);
  throw BadInput(
      "{}: its extension is not that of a measurement; `format` says which it is: csv, alta, astm, zemax or "
      "merl",
      file.string());
}

}  // namespace

Measurement read_measurement(const std::filesystem::path& file, const MeasurementOptions& options) {
  const std::string format = options.format.empty() ? format_of(file) : options.format;
  const auto reader =
      std::find_if(readers.begin(), readers.end(), [&](const Reader& r) { return r.format == format; });
  if (reader == readers.end())
    throw BadInput(GivenValue{"format", format}, "must be csv, alta, astm, zemax or merl");
  Measurement measurement;
  if (file == "-") {
    measurement = reader->read(std::cin, "standard input", options);
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) throw FileError("{}: is a folder", file.string());
    std::ifstream in(file, std::ios::binary);
    if (!in)
      throw FileError("{}: cannot be opened: {}", file.string(), std::generic_category().message(errno));
    measurement = reader->read(in, file.string(), options);
    if (in.bad()) throw FileError("{}: cannot be read", file.string());
  }
  if (reader->lists_grids) set_aside_repeats_of_grid(measurement);
  measurement.incidence_width = options.incidence_width;
  unite_channels(measurement, options.wavelength_unit);
  const ValueKind kind = options.values.value_or(ValueKind::brdf);
  for (auto& sample : measurement.samples) {
    const double theta_s = sample.pair.model_theta_s();
    sample.brdf = options.scale * brdf_of(kind, sample.brdf, theta_s);
    sample.sigma *= options.scale * slope_of_brdf(kind, sample.brdf / options.scale, theta_s);
    if (options.flip_azimuth) sample.pair.phi += 180;
  }
  choose_light(measurement, options.light, reader->format == "csv");
  clean(measurement, options);
  return measurement;
}

}  // namespace brdftab

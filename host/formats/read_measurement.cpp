#include "host/formats/read_measurement.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <iostream>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/registry.hpp"
#include "host/model/measurement/measured_light.hpp"

namespace brdftab {
namespace {

// What standard input holds, unless the user says otherwise.
constexpr std::string_view format_of_stream = "csv";

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

MeasurementReader reader_named(const Formats& formats, const std::string& name) {
  const Format* format = find_format(formats, name);
  if (!format || !format->traits().measurement)
    throw BadInput(GivenValue{"format", name}, "must be {}", fmt::join(measurement_formats(), ", "));
  return *format->traits().measurement;
}

MeasurementReader reader_of(const Formats& formats, const std::filesystem::path& file) {
  if (file == "-") return reader_named(formats, std::string(format_of_stream));
  const std::string extension = lower(file.extension().string());
  for (const auto& format : formats) {
    const auto& reader = format->traits().measurement;
    if (reader && std::find(reader->extensions.begin(), reader->extensions.end(), extension) !=
                      reader->extensions.end())
      return *reader;
  }
  throw BadInput("{}: its extension is not that of a measurement; `format` says which it is: {}",
                 file.string(), fmt::join(measurement_formats(), ", "));
}

}  // namespace

std::vector<std::string> measurement_formats() {
  std::vector<std::string> names;
  for (const auto& format : all_formats())
    if (format->traits().measurement) names.emplace_back(format->traits().name);
  return names;
}

Measurement read_measurement(const std::filesystem::path& file, const MeasurementOptions& options) {
  const Formats formats = all_formats();
  const MeasurementReader reader =
      options.format.empty() ? reader_of(formats, file) : reader_named(formats, options.format);
  Measurement measurement;
  if (file == "-") {
    measurement = reader.read(std::cin, "standard input", options);
  } else {
    std::ifstream in = open_file(file);
    measurement = reader.read(in, file.string(), options);
    if (in.bad()) throw FileError("{}: cannot be read", file.string());
  }
  if (reader.lists_grids) set_aside_repeats_of_grid(measurement);
  measurement.incidence_width = options.incidence_width;
  unite_channels(measurement, options.wavelength_unit);
  const ValueKind kind = options.values.value_or(ValueKind::brdf);
  for (auto& sample : measurement.samples) {
    const double theta_s = sample.pair.model_theta_s();
    sample.brdf = options.scale * brdf_of(kind, sample.brdf, theta_s);
    sample.sigma *= options.scale * slope_of_brdf(kind, sample.brdf / options.scale, theta_s);
    if (options.flip_azimuth) sample.pair.phi += 180;
  }
  choose_light(measurement, options.light, reader.tells_light);
  clean(measurement, options);
  return measurement;
}

}  // namespace brdftab

#include "host/measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <numbers>
#include <set>
#include <tuple>

#include "host/error.hpp"
#include "host/measurement_text.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// A diffuse reflectance above 1 by more than a measurement's error; a radiance factor, pi f, reads at most pi times too high.
constexpr double suspicious_reflectance = 1.1;
// From here on a surface's forward scatter exceeds its backward scatter by far, unless it retro-reflects.
constexpr double high_incidence = 45;
constexpr double suspicious_asymmetry = 2;

bool is_backward(const DirectionPair& pair) { return std::cos(pair.model_phi() * std::numbers::pi / 180) < 0; }

void set_aside_what_is_not_positive(Measurement& measurement) {
  std::size_t nans = 0;
  std::size_t zeros = 0;
  std::size_t negatives = 0;
  const std::size_t count = measurement.samples.size();
  std::erase_if(measurement.samples, [&](const MeasuredSample& sample) {
    nans += std::isnan(sample.brdf);
    zeros += sample.brdf == 0;
    negatives += sample.brdf < 0;
    return !(sample.brdf > 0);
  });
  const auto warn = [&](std::size_t number, std::string_view what) {
    if (number > 0) measurement.warnings.push_back(fmt::format("{} of {} samples are {}: set aside", number, count, what));
  };
  warn(nans, "nan");
  warn(zeros, "zero");
  warn(negatives, "negative");
}

using Direction = std::tuple<std::size_t, double, double, double>;

// At the normal all azimuths are one direction.
Direction direction_of(const MeasuredSample& sample) {
  const double theta_s = sample.pair.model_theta_s();
  const double phi = theta_s == 0 ? 0 : std::remainder(sample.pair.model_phi(), 360);
  return {sample.channel, sample.pair.theta_i, theta_s, phi == -180 ? 180 : phi};
}

// Each is information, its value the same or not: instruments round, and read a direction more than once.
void count_repeated_readings(Measurement& measurement) {
  std::set<Direction> directions;
  std::set<std::pair<Direction, double>> readings;
  std::size_t again = 0;
  std::size_t equal = 0;
  for (const MeasuredSample& sample : measurement.samples) {
    again += !directions.insert(direction_of(sample)).second;
    equal += !readings.insert({direction_of(sample), sample.brdf}).second;
  }
  if (again > 0)
    measurement.warnings.push_back(fmt::format(
        "{} samples have the directions of an earlier one, {} of them its value too: each counts as a reading of its own", again,
        equal));
}

// A tenth of the values lie below this one: the diffuse level, whatever peaks there are.
double low_level(std::vector<double> values) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 10);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

void warn_of_other_units(Measurement& measurement) {
  std::map<std::pair<std::size_t, double>, std::vector<double>> by_incidence;
  for (const auto& sample : measurement.samples)
    if (sample.pair.model_theta_s() <= 60) by_incidence[{sample.channel, sample.pair.theta_i}].push_back(sample.brdf);
  double lowest = std::numeric_limits<double>::infinity();
  for (auto& [key, values] : by_incidence)
    if (values.size() >= 5) lowest = std::min(lowest, low_level(values));
  if (!std::isfinite(lowest)) return;
  const double reflectance = std::numbers::pi * lowest;
  if (reflectance <= suspicious_reflectance) return;
  const bool is_percent = reflectance > suspicious_reflectance * std::numbers::pi;
  measurement.warnings.push_back(fmt::format(
      "f is at least {:.3g} 1/sr at nearly all directions, a reflectance of {:.3g}: this looks like {}; {} mends that", lowest,
      reflectance, is_percent ? "percent" : "pi f", is_percent ? "--scale 0.01" : "--scale 0.3183099"));
}

void warn_of_reversed_azimuth(Measurement& measurement) {
  double highest = 0;
  for (const auto& sample : measurement.samples) highest = std::max(highest, sample.pair.theta_i);
  if (highest < high_incidence) return;
  double forward = 0;
  double backward = 0;
  for (const auto& sample : measurement.samples)
    if (sample.pair.theta_i == highest && sample.pair.model_theta_s() > 0) {
      double& peak = is_backward(sample.pair) ? backward : forward;
      peak = std::max(peak, sample.brdf);
    }
  if (forward > 0 && backward > suspicious_asymmetry * forward)
    measurement.warnings.push_back(
        fmt::format("at theta_i = {} degrees the peak is on the backward side, {:.3g} against {:.3g} 1/sr: unless the material "
                    "retro-reflects, the azimuth is counted from the other side; --flip-azimuth turns it",
                    shortest(highest), backward, forward));
}

struct Reader {
  std::string_view format;
  std::array<std::string_view, 2> extensions;
  Measurement (*read)(std::istream&, const std::string&);
};

constexpr std::array<Reader, 5> readers{{{"csv", {".csv", ".csv"}, read_csv_measurement},
                                         {"alta", {".alta", ".dat"}, read_alta_measurement},
                                         {"astm", {".astm", ".astm"}, read_astm_measurement},
                                         {"zemax", {".bsdf", ".bsdf"}, read_zemax_measurement},
                                         {"merl", {".binary", ".binary"}, read_merl_measurement}}};

std::string format_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (file == "-") return "csv";
  for (const Reader& reader : readers)
    if (std::find(reader.extensions.begin(), reader.extensions.end(), extension) != reader.extensions.end())
      return std::string(reader.format);
  throw BadInput("{}: its extension is not that of a measurement; --format says which it is: csv, alta, astm, zemax or merl",
                 file.string());
}

}  // namespace

bool Measurement::has_sigma() const {
  return !samples.empty() && std::none_of(samples.begin(), samples.end(), [](const auto& s) { return std::isnan(s.sigma); });
}

Incidences Measurement::incidences() const {
  std::vector<double> theta_i;
  for (const auto& sample : samples) theta_i.push_back(sample.pair.theta_i);
  return {theta_i, incidence_width};
}

std::optional<double> Measurement::wavelength_nm(std::size_t channel) const {
  std::string_view name = channels[channel];
  if (name.ends_with("nm")) name.remove_suffix(2);
  const auto value = parse_number(name);
  return value && std::isfinite(*value) && *value > 0 ? value : std::nullopt;
}

Measurement Measurement::channel(std::size_t index) const {
  Measurement result{.source = source,
                     .channels = {channels[index]},
                     .samples = {},
                     .warnings = {},
                     .incidence_width = incidence_width};
  for (MeasuredSample sample : samples)
    if (sample.channel == index) {
      sample.channel = 0;
      result.samples.push_back(sample);
    }
  return result;
}

void set_aside_repeats_of_grid(Measurement& measurement) {
  std::map<Direction, double> values;
  for (const MeasuredSample& sample : measurement.samples) {
    const auto [at, is_new] = values.try_emplace(direction_of(sample), sample.brdf);
    if (!is_new && at->second != sample.brdf && !(std::isnan(at->second) && std::isnan(sample.brdf))) return;
  }
  std::set<Direction> seen;
  const std::size_t repeated =
      std::erase_if(measurement.samples, [&](const MeasuredSample& sample) { return !seen.insert(direction_of(sample)).second; });
  if (repeated > 0)
    measurement.warnings.push_back(
        fmt::format("{} rows repeat the value of an earlier one in the same direction, as grids do at "
                    "theta_s = 0 and over a whole turn: set aside",
                    repeated));
}

void clean(Measurement& measurement) {
  if (measurement.samples.empty()) throw BadInput("{}: has no samples", measurement.source);
  set_aside_what_is_not_positive(measurement);
  if (measurement.samples.empty()) throw BadInput("{}: no sample has f above 0", measurement.source);
  count_repeated_readings(measurement);
  warn_of_other_units(measurement);
  warn_of_reversed_azimuth(measurement);
}

Measurement read_measurement(const std::filesystem::path& file, const MeasurementOptions& options) {
  const std::string format = options.format.empty() ? format_of(file) : options.format;
  const auto reader = std::find_if(readers.begin(), readers.end(), [&](const Reader& r) { return r.format == format; });
  if (reader == readers.end()) throw BadInput("--format {}: must be csv, alta, astm, zemax or merl", format);
  Measurement measurement;
  if (file == "-") {
    measurement = reader->read(std::cin, "standard input");
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(file, error)) throw FileError("{}: is a folder", file.string());
    std::ifstream in(file, std::ios::binary);
    if (!in) throw FileError("{}: cannot be opened: {}", file.string(), std::generic_category().message(errno));
    measurement = reader->read(in, file.string());
    if (in.bad()) throw FileError("{}: cannot be read", file.string());
  }
  measurement.incidence_width = options.incidence_width;
  for (auto& sample : measurement.samples) {
    sample.brdf *= options.scale;
    sample.sigma *= options.scale;
    if (options.flip_azimuth) sample.pair.phi += 180;
  }
  clean(measurement);
  return measurement;
}

}  // namespace brdftab

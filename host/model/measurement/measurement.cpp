#include "host/model/measurement/measurement.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/measurement/doubts.hpp"

namespace brdftab {
namespace {

// Readings that noise has brought to 0 or below are readings; a fit says which it takes.
void set_aside_what_is_no_number(Measurement& measurement) {
  std::size_t nans = 0;
  std::size_t zeros = 0;
  std::size_t negatives = 0;
  const std::size_t count = measurement.samples.size();
  std::erase_if(measurement.samples, [&](const MeasuredSample& sample) {
    nans += std::isnan(sample.brdf);
    zeros += sample.brdf == 0;
    negatives += sample.brdf < 0;
    return std::isnan(sample.brdf);
  });
  const auto warn = [&](std::size_t number, std::string_view what) {
    if (number > 0)
      measurement.warnings.push_back(fmt::format("{} of {} samples are {}", number, count, what));
  };
  warn(nans, "nan: set aside");
  warn(zeros, "zero");
  warn(negatives, "negative");
}

// A direction is told by its channel, light and angles.
using Direction = std::tuple<std::size_t, double, double, double, double>;

// At the normal all azimuths are one direction.
Direction direction_of(const MeasuredSample& sample) {
  const double theta_s = sample.pair.model_theta_s();
  const double phi = theta_s == 0 ? 0 : std::remainder(sample.pair.model_phi(), 360);
  return {sample.channel, sample.share_s, sample.pair.theta_i, theta_s, phi == -180 ? 180 : phi};
}

// Instruments round, and read a direction more than once: each reading is information, its value the same or
// not.
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
    measurement.warnings.push_back(
        fmt::format("{} samples have the directions of an earlier one, {} of them its value too: each counts "
                    "as a reading of its own",
                    again, equal));
}

}  // namespace

bool Measurement::has_sigma() const {
  return !samples.empty() &&
         std::none_of(samples.begin(), samples.end(), [](const auto& s) { return std::isnan(s.sigma); });
}

Incidences Measurement::incidences() const {
  std::vector<double> theta_i;
  for (const auto& sample : samples) theta_i.push_back(sample.pair.theta_i);
  return {theta_i, incidence_width};
}

std::optional<double> Measurement::wavelength_nm(std::size_t channel) const {
  const auto wavelength = parse_wavelength(channels[channel]);
  return wavelength ? std::optional(wavelength->nm) : std::nullopt;
}

std::optional<std::size_t> Measurement::find_channel(std::string_view name) const {
  const auto wavelength = parse_wavelength(name);
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const auto other = wavelength_nm(c);
    if (channels[c] == name || (wavelength && other && is_same_wavelength(wavelength->nm, *other))) return c;
  }
  return std::nullopt;
}

Measurement Measurement::channel(std::size_t index) const {
  Measurement result{.source = source,
                     .channels = {channels[index]},
                     .samples = {},
                     .warnings = {},
                     .incidence_width = incidence_width,
                     .mean_of_exchanges = mean_of_exchanges};
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
  const std::size_t repeated = std::erase_if(measurement.samples, [&](const MeasuredSample& sample) {
    return !seen.insert(direction_of(sample)).second;
  });
  if (repeated > 0)
    measurement.warnings.push_back(
        fmt::format("{} rows repeat the value of an earlier one in the same direction, as grids do at "
                    "theta_s = 0 and over a whole turn: set aside",
                    repeated));
}

void unite_channels(Measurement& measurement, const std::optional<WavelengthUnit>& unit) {
  std::vector<std::string> names;
  std::vector<std::size_t> united;
  for (const std::string& text : measurement.channels) {
    const auto wavelength = parse_wavelength(text, unit.value_or(wavelength_units[0]));
    const auto is_this = [&](const std::string& name) {
      const auto other = parse_wavelength(name);
      return wavelength && other ? is_same_wavelength(wavelength->nm, other->nm) : name == text;
    };
    united.push_back(
        static_cast<std::size_t>(std::find_if(names.begin(), names.end(), is_this) - names.begin()));
    if (united.back() < names.size()) continue;
    names.push_back(wavelength && wavelength->nm_per_unit != 1 ? shortest(wavelength->nm) : text);
  }
  measurement.channels = std::move(names);
  for (auto& sample : measurement.samples) sample.channel = united[sample.channel];
}

void clean(Measurement& measurement, const MeasurementOptions& options) {
  if (measurement.samples.empty()) throw BadInput("{}: has no samples", measurement.source);
  const auto add = [&](std::string doubt) {
    if (!doubt.empty()) measurement.warnings.push_back(std::move(doubt));
  };
  // What the user says of the values is not questioned.
  const bool are_known = options.values == ValueKind::brdf;
  const std::string logarithms = are_known ? std::string() : doubt_of_logarithms(measurement);
  add(logarithms);
  set_aside_what_is_no_number(measurement);
  if (std::none_of(measurement.samples.begin(), measurement.samples.end(),
                   [](const auto& sample) { return sample.brdf > 0; }))
    throw BadInput("{}: no sample has f above 0{}{}", measurement.source, logarithms.empty() ? "" : ": ",
                   logarithms);
  count_repeated_readings(measurement);
  if (!are_known && logarithms.empty()) {
    add(doubt_of_level(measurement));
    add(doubt_of_cosine(measurement));
  }
  if (logarithms.empty()) add(doubt_of_azimuth(measurement));
  add(doubt_of_geometry(measurement));
  if (!options.wavelength_unit) add(doubt_of_wavelengths(measurement));
}

}  // namespace brdftab

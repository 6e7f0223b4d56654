// ALTA and ASTM text: lists of pairs of directions in radians, both away from the surface, so that the specular direction
// lies at phi_i + 180 degrees.
#include "host/measurement_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "host/error.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// Degrees, without the last digits that radians in text leave: incidences are told apart by their value.
double degrees(double radians) { return std::round(radians * 180 / std::numbers::pi * 1e6) / 1e6; }

std::vector<double> numbers_of(std::string line, const std::string& where) {
  std::replace(line.begin(), line.end(), ',', ' ');
  std::istringstream words(line);
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    const auto value = parse_number(word);
    if (!value) throw BadInput("{}: {}: must be a number", where, excerpt(word));
    numbers.push_back(*value);
  }
  return numbers;
}

/// Radians. `phi` is from the incident azimuth, 0 towards retro-reflection. Lists over a closed hemisphere have samples at its
/// rim, where neither f nor a model of it has a value: false.
bool add(Measurement& measurement, double theta_i, double theta_s, double phi, double brdf, std::size_t channel,
         const std::string& where, std::size_t line) {
  MeasuredSample sample{
      .pair = {degrees(theta_i), degrees(theta_s), degrees(phi - std::numbers::pi), line}, .brdf = brdf, .channel = channel};
  if (sample.pair.theta_i == 90 || sample.pair.theta_s == 90) return false;
  for (const auto& [name, theta] : {std::pair{"theta_i", sample.pair.theta_i}, {"theta_s", sample.pair.theta_s}})
    if (!(theta >= 0 && theta < 90))
      throw BadInput("{}: {} = {} degrees: must be a number from 0 to below 90 degrees", where, name, shortest(theta));
  if (!std::isfinite(sample.pair.phi) || std::isinf(brdf)) throw BadInput("{}: an azimuth or a value is not finite", where);
  measurement.samples.push_back(sample);
  return true;
}

void warn_of_rim(Measurement& measurement, std::size_t samples) {
  if (samples > 0) measurement.warnings.push_back(fmt::format("{} samples at theta = 90 degrees: set aside", samples));
}

struct DirectionsRadians {
  double theta_i, theta_s, phi;
};

/// How a line's first numbers give directions; phi as `add` takes it.
struct AltaParametrization {
  std::string_view name;
  std::size_t inputs;
  DirectionsRadians (*directions)(const double*);
};

constexpr std::array<AltaParametrization, 3> alta_parametrizations{{
    {"SPHERICAL_TL_PL_TV_PV", 4,
     [](const double* x) {
       return DirectionsRadians{x[0], x[2], x[3] - x[1]};
     }},
    {"ISOTROPIC_TV_TL_DPHI", 3,
     [](const double* x) {
       return DirectionsRadians{x[1], x[0], x[2]};
     }},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", 3,
     [](const double* x) {
       return DirectionsRadians{x[0], std::hypot(x[1], x[2]), std::atan2(x[2], x[1])};
     }},
}};

const AltaParametrization& alta_parametrization(const std::string& name, const std::string& where) {
  for (const auto& row : alta_parametrizations)
    if (row.name == name) return row;
  throw BadInput("{}: PARAM_IN {}: must be {}, {} or {}", where, excerpt(name), alta_parametrizations[0].name,
                 alta_parametrizations[1].name, alta_parametrizations[2].name);
}

}  // namespace

Measurement read_alta_measurement(std::istream& in, const std::string& source) {
  Measurement measurement;
  measurement.source = source;
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  const AltaParametrization* parametrization = &alta_parametrizations[0];
  std::size_t at_rim = 0;
  bool cosine = false;
  std::size_t line = 0;
  for (std::string text; std::getline(in, text);) {
    const std::string where = fmt::format("{}:{}", source, ++line);
    const auto content = trimmed(text);
    if (content.empty()) continue;
    if (content.starts_with('#')) {
      std::istringstream words{std::string(content.substr(1))};
      std::string key, value;
      words >> key >> value;
      if (key == "DIM") {
        std::string second;
        words >> second;
        inputs = static_cast<std::size_t>(parse_number(value).value_or(0));
        outputs = static_cast<std::size_t>(parse_number(second).value_or(0));
      } else if (key == "PARAM_IN") {
        parametrization = &alta_parametrization(value, where);
      } else if (key == "PARAM_OUT") {
        cosine = value == "INV_STERADIAN_COSINE_FACTOR";
        if (!cosine && value != "INV_STERADIAN" && value != "RGB_COLOR")
          throw BadInput("{}: PARAM_OUT {}: must be INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR or RGB_COLOR", where,
                         excerpt(value));
      } else if (key == "FORMAT" && value == "binary") {
        throw BadInput("{}: FORMAT binary: only ALTA's text is read", where);
      }
      continue;
    }
    if (inputs != parametrization->inputs || outputs < 1 || outputs > 10000)
      throw BadInput("{}: the header must give #DIM with {} angles and at least one value, and #PARAM_IN", where,
                     parametrization->inputs);
    if (measurement.channels.empty())
      for (std::size_t c = 0; c < outputs; ++c)
        measurement.channels.push_back(outputs == 1 ? "" : outputs == 3 ? std::string(1, "RGB"[c]) : std::to_string(c + 1));
    const auto numbers = numbers_of(text, where);
    if (numbers.size() < inputs + outputs)
      throw BadInput("{}: has {} numbers where #DIM says {}", where, numbers.size(), inputs + outputs);
    const auto [theta_i, theta_s, phi] = parametrization->directions(numbers.data());
    for (std::size_t c = 0; c < outputs; ++c)
      at_rim += !add(measurement, theta_i, theta_s, phi, numbers[inputs + c] / (cosine ? std::cos(theta_s) : 1), c, where, line);
  }
  warn_of_rim(measurement, at_rim);
  set_aside_repeats_of_grid(measurement);
  return measurement;
}

Measurement read_astm_rows(std::istream& in, const std::string& source) {
  Measurement measurement;
  measurement.source = source;
  std::size_t at_rim = 0;
  std::size_t line = 0;
  for (std::string text; std::getline(in, text);) {
    const std::string where = fmt::format("{}:{}", source, ++line);
    const auto content = trimmed(text);
    if (content.empty()) continue;
    if (measurement.channels.empty()) {
      if (!content.starts_with("VARS")) continue;
      std::istringstream names{std::string(trimmed(content.substr(4)))};
      std::vector<std::string> list;
      for (std::string name; std::getline(names, name, ',');) list.emplace_back(trimmed(name));
      if (list.size() < 5 || list[0] != "theta_i" || list[1] != "phi_i" || list[2] != "theta_s" || list[3] != "phi_s")
        throw BadInput("{}: VARS {}: must be theta_i,phi_i,theta_s,phi_s and at least one channel", where,
                       excerpt(content.substr(4)));
      measurement.channels.assign(list.begin() + 4, list.end());
      continue;
    }
    const auto numbers = numbers_of(text, where);
    if (numbers.size() != 4 + measurement.channels.size())
      throw BadInput("{}: has {} numbers where VARS names {}", where, numbers.size(), 4 + measurement.channels.size());
    for (std::size_t c = 0; c < measurement.channels.size(); ++c)
      at_rim += !add(measurement, numbers[0], numbers[2], numbers[3] - numbers[1], numbers[4 + c], c, where, line);
  }
  warn_of_rim(measurement, at_rim);
  if (measurement.channels.empty()) throw BadInput("{}:1: has no line VARS theta_i,phi_i,theta_s,phi_s,...", source);
  return measurement;
}

Measurement read_astm_measurement(std::istream& in, const std::string& source) {
  Measurement measurement = read_astm_rows(in, source);
  set_aside_repeats_of_grid(measurement);
  return measurement;
}

}  // namespace brdftab

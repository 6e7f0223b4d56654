// ALTA and ASTM text: lists of pairs of directions in radians, both away from the surface, so that the specular direction
// lies at phi_i + 180 degrees.
#include "host/measurement_text.hpp"

#include <algorithm>
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

void add(Measurement& measurement, double theta_i, double theta_s, double phi, double brdf, std::size_t channel,
         const std::string& where, std::size_t line) {
  MeasuredSample sample{.pair = {degrees(theta_i), degrees(theta_s), degrees(phi), line}, .brdf = brdf, .channel = channel};
  for (const auto& [name, theta] : {std::pair{"theta_i", sample.pair.theta_i}, {"theta_s", sample.pair.theta_s}})
    if (!(theta >= 0 && theta < 90))
      throw BadInput("{}: {} = {} degrees: must be a number from 0 to below 90 degrees", where, name, shortest(theta));
  if (!std::isfinite(sample.pair.phi) || std::isinf(brdf)) throw BadInput("{}: an azimuth or a value is not finite", where);
  measurement.samples.push_back(sample);
}

}  // namespace

Measurement read_alta_measurement(std::istream& in, const std::string& source) {
  Measurement measurement;
  measurement.source = source;
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  bool isotropic = false;
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
        isotropic = value == "ISOTROPIC_TV_TL_DPHI";
        if (!isotropic && value != "SPHERICAL_TL_PL_TV_PV")
          throw BadInput("{}: PARAM_IN {}: must be SPHERICAL_TL_PL_TV_PV or ISOTROPIC_TV_TL_DPHI", where, excerpt(value));
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
    if (inputs != (isotropic ? 3u : 4u) || outputs < 1 || outputs > 10000)
      throw BadInput("{}: the header must give #DIM with {} angles and at least one value, and #PARAM_IN", where,
                     isotropic ? 3 : 4);
    if (measurement.channels.empty())
      for (std::size_t c = 0; c < outputs; ++c)
        measurement.channels.push_back(outputs == 1 ? "" : outputs == 3 ? std::string(1, "RGB"[c]) : std::to_string(c + 1));
    const auto numbers = numbers_of(text, where);
    if (numbers.size() < inputs + outputs)
      throw BadInput("{}: has {} numbers where #DIM says {}", where, numbers.size(), inputs + outputs);
    const double theta_i = isotropic ? numbers[1] : numbers[0];
    const double theta_s = isotropic ? numbers[0] : numbers[2];
    const double phi = (isotropic ? numbers[2] : numbers[3] - numbers[1]) - std::numbers::pi;
    for (std::size_t c = 0; c < outputs; ++c)
      add(measurement, theta_i, theta_s, phi, numbers[inputs + c] / (cosine ? std::cos(theta_s) : 1), c, where, line);
  }
  return measurement;
}

Measurement read_astm_measurement(std::istream& in, const std::string& source) {
  Measurement measurement;
  measurement.source = source;
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
      add(measurement, numbers[0], numbers[2], numbers[3] - numbers[1] - std::numbers::pi, numbers[4 + c], c, where, line);
  }
  if (measurement.channels.empty()) throw BadInput("{}:1: has no line VARS theta_i,phi_i,theta_s,phi_s,...", source);
  return measurement;
}

}  // namespace brdftab

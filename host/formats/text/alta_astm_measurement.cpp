#include "host/formats/text/alta_astm_measurement.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <sstream>
#include <tuple>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/registry.hpp"

namespace brdftab {
namespace {

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

// A quarter of a turn in few digits, 1.571 for pi/2, lies a little beyond it.
constexpr double beyond_rim = 0.02;

/// Makes samples of a measurement from rows whose angles are as the file has them. `phi` counts from the
/// incident azimuth, where 0 is towards retro-reflection.
class Rows {
 public:
  Rows(Measurement& measurement, const MeasurementOptions& options)
      : measurement_(measurement), unit_(options.angles.value_or(*parse_angle_unit("radians"))) {}

  double half_turn() const { return 180 / unit_.phi; }
  double cosine(double theta) const { return std::cos(theta * unit_.theta * std::numbers::pi / 180); }

  /// Lists over a closed hemisphere have samples at its rim, where neither f nor a model of it has a value:
  /// they are counted.
  void add(double theta_i, double theta_s, double phi, double brdf, std::size_t channel,
           const std::string& where, std::size_t line) {
    MeasuredSample sample{.pair = {in_degrees(theta_i, unit_.theta), in_degrees(theta_s, unit_.theta),
                                   in_degrees(phi - half_turn(), unit_.phi), line},
                          .brdf = brdf,
                          .channel = channel};
    for (const auto& [name, theta, given] :
         {std::tuple{"theta_i", sample.pair.theta_i, theta_i}, {"theta_s", sample.pair.theta_s, theta_s}})
      if (!(theta >= 0 && theta <= 90 + beyond_rim))
        throw BadInput(
            "{}: {} = {}: must be from 0 to below {}{}", where, name, shortest(given),
            unit_.theta == 1 ? "90 degrees" : "pi/2 radians",
            unit_.theta == 1 ? "" : "; where the file has degrees, `angles` degrees takes them so");
    if (!std::isfinite(phi) || std::isinf(brdf))
      throw BadInput("{}: an azimuth or a value is not finite", where);
    if (std::abs(phi) > 4 * half_turn())
      throw BadInput(
          "{}: an azimuth of {} {} is over two turns; `angles` says the unit: degrees, radians or "
          "azimuth-radians",
          where, shortest(phi), unit_.phi == 1 ? "degrees" : "radians");
    if (std::max(sample.pair.theta_i, sample.pair.theta_s) >= 90)
      ++at_rim_;
    else
      measurement_.samples.push_back(sample);
  }

  void warn_of_rim() {
    if (at_rim_ > 0)
      measurement_.warnings.push_back(fmt::format("{} samples at theta = 90 degrees: set aside", at_rim_));
  }

 private:
  Measurement& measurement_;
  AngleUnit unit_;
  std::size_t at_rim_ = 0;
};

struct Angles {
  double theta_i, theta_s, phi;
};

/// How a line's first numbers give angles, as `Rows` takes them.
struct AltaParametrization {
  std::string_view name;
  std::size_t inputs;
  Angles (*angles)(const double*, double half_turn);
};

constexpr std::array<AltaParametrization, 3> alta_parametrizations{{
    {"SPHERICAL_TL_PL_TV_PV", 4,
     [](const double* x, double) {
       return Angles{x[0], x[2], x[3] - x[1]};
     }},
    {"ISOTROPIC_TV_TL_DPHI", 3,
     [](const double* x, double) {
       return Angles{x[1], x[0], x[2]};
     }},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", 3,
     [](const double* x, double half_turn) {
       return Angles{x[0], std::hypot(x[1], x[2]), std::atan2(x[2], x[1]) / std::numbers::pi * half_turn};
     }},
}};

const AltaParametrization& alta_parametrization(const std::string& name, const std::string& where) {
  for (const auto& row : alta_parametrizations)
    if (row.name == name) return row;
  throw BadInput("{}: PARAM_IN {}: must be {}, {} or {}", where, excerpt(name), alta_parametrizations[0].name,
                 alta_parametrizations[1].name, alta_parametrizations[2].name);
}

}  // namespace

Measurement read_alta_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options) {
  Measurement measurement;
  measurement.source = source;
  std::size_t inputs = 0;
  std::size_t outputs = 0;
  const AltaParametrization* parametrization = &alta_parametrizations[0];
  Rows rows(measurement, options);
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
          throw BadInput("{}: PARAM_OUT {}: must be INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR or RGB_COLOR",
                         where, excerpt(value));
      } else if (key == "FORMAT" && value == "binary") {
        throw BadInput("{}: FORMAT binary: only ALTA's text is read", where);
      }
      continue;
    }
    if (inputs != parametrization->inputs || outputs < 1 || outputs > 10000)
      throw BadInput("{}: the header must give #DIM with {} angles and at least one value, and #PARAM_IN",
                     where, parametrization->inputs);
    if (measurement.channels.empty())
      for (std::size_t c = 0; c < outputs; ++c)
        measurement.channels.push_back(outputs == 1   ? ""
                                       : outputs == 3 ? std::string(1, "RGB"[c])
                                                      : std::to_string(c + 1));
    const auto numbers = numbers_of(text, where);
    if (numbers.size() < inputs + outputs)
      throw BadInput("{}: has {} numbers where #DIM says {}", where, numbers.size(), inputs + outputs);
    const auto [theta_i, theta_s, phi] = parametrization->angles(numbers.data(), rows.half_turn());
    for (std::size_t c = 0; c < outputs; ++c)
      rows.add(theta_i, theta_s, phi, numbers[inputs + c] / (cosine ? rows.cosine(theta_s) : 1), c, where,
               line);
  }
  rows.warn_of_rim();
  return measurement;
}

Measurement read_astm_measurement(std::istream& in, const std::string& source,
                                  const MeasurementOptions& options) {
  Measurement measurement;
  measurement.source = source;
  Rows rows(measurement, options);
  std::size_t line = 0, points = 0;
  std::optional<double> points_said;
  for (std::string text; std::getline(in, text);) {
    const std::string where = fmt::format("{}:{}", source, ++line);
    const auto content = trimmed(text);
    if (content.empty()) continue;
    if (measurement.channels.empty()) {
      if (content.starts_with("NUM_POINTS")) points_said = parse_number(content.substr(10));
      if (!content.starts_with("VARS")) continue;
      std::istringstream names{std::string(trimmed(content.substr(4)))};
      std::vector<std::string> list;
      for (std::string name; std::getline(names, name, ',');) list.emplace_back(trimmed(name));
      if (list.size() < 5 || list[0] != "theta_i" || list[1] != "phi_i" || list[2] != "theta_s" ||
          list[3] != "phi_s")
        throw BadInput("{}: VARS {}: must be theta_i,phi_i,theta_s,phi_s and at least one channel", where,
                       excerpt(content.substr(4)));
      measurement.channels.assign(list.begin() + 4, list.end());
      continue;
    }
    const auto numbers = numbers_of(text, where);
    if (numbers.size() != 4 + measurement.channels.size())
      throw BadInput("{}: has {} numbers where VARS names {}", where, numbers.size(),
                     4 + measurement.channels.size());
    ++points;
    for (std::size_t c = 0; c < measurement.channels.size(); ++c)
      rows.add(numbers[0], numbers[2], numbers[3] - numbers[1], numbers[4 + c], c, where, line);
  }
  rows.warn_of_rim();
  if (points_said && *points_said != static_cast<double>(points))
    measurement.warnings.push_back(
        fmt::format("has {} rows where NUM_POINTS says {}: {}", points, shortest(*points_said),
                    *points_said > static_cast<double>(points) ? "the file may be cut short"
                                                               : "its header is another file's"));
  if (measurement.channels.empty())
    throw BadInput("{}:1: has no line VARS theta_i,phi_i,theta_s,phi_s,...", source);
  return measurement;
}

std::unique_ptr<Format> make_alta_format() {
  return std::make_unique<Format>(
      FormatTraits{.name = "alta",
                   .consumer = "ALTA",
                   .measurement = MeasurementReader{
                       .extensions = {".alta", ".dat"}, .read = read_alta_measurement, .lists_grids = true}});
}

}  // namespace brdftab

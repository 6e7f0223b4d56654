// Zemax OpticStudio's tabular BSDF: scatter angles about the specular direction.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "host/error.hpp"
#include "host/measurement_text.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// Words with the line each stands in; `#` begins a comment.
class Words {
 public:
  Words(std::istream& in, const std::string& source) : source_(source) {
    std::size_t line = 0;
    for (std::string text; std::getline(in, text);) {
      ++line;
      std::istringstream words(text.substr(0, text.find('#')));
      for (std::string word; words >> word;) words_.push_back({word, line});
    }
  }

  bool ended() const { return at_ == words_.size(); }
  std::string where() const {
    return fmt::format("{}:{}", source_, words_.empty() ? 1 : words_[std::min(at_, words_.size() - 1)].second);
  }
  std::string word() {
    if (ended()) throw BadInput("{}: ends too early", where());
    return words_[at_++].first;
  }
  double number() {
    const std::string place = where();
    const std::string text = word();
    const auto value = parse_number(text);
    if (!value || !std::isfinite(*value)) throw BadInput("{}: {}: must be a number", place, excerpt(text));
    return *value;
  }
  void expect(std::string_view wanted) {
    const std::string place = where();
    const std::string text = word();
    if (text != wanted) throw BadInput("{}: {}: must be {}", place, excerpt(text), wanted);
  }
  std::size_t line() const { return words_[at_ == 0 ? 0 : at_ - 1].second; }

 private:
  const std::string& source_;
  std::vector<std::pair<std::string, std::size_t>> words_;
  std::size_t at_ = 0;
};

constexpr double radian = std::numbers::pi / 180;

// theta_s and phi, 0 forward, of a direction at `radial` degrees from the specular one; azimuth 0 points to the normal.
std::pair<double, double> scattered(double theta_i, double radial, double azimuth) {
  const double along = std::sin(radial * radian) * std::cos(azimuth * radian);
  const double z = std::cos(radial * radian) * std::cos(theta_i * radian) + along * std::sin(theta_i * radian);
  const double x = std::cos(radial * radian) * std::sin(theta_i * radian) - along * std::cos(theta_i * radian);
  const double y = std::sin(radial * radian) * std::sin(azimuth * radian);
  const auto rounded = [](double angle) { return std::round(angle / radian * 1e6) / 1e6; };
  return {rounded(std::atan2(std::hypot(x, y), z)), rounded(std::atan2(y, x))};
}

}  // namespace

Measurement read_zemax_measurement(std::istream& in, const std::string& source) {
  Words words(in, source);
  Measurement measurement;
  measurement.source = source;
  std::map<std::string, std::vector<double>> lists;
  constexpr std::array<std::string_view, 4> axes{"SampleRotation", "AngleOfIncidence", "ScatterAzimuth", "ScatterRadial"};
  std::size_t below_horizon = 0;
  while (!words.ended()) {
    const std::string place = words.where();
    const std::string key = words.word();
    if (std::find(axes.begin(), axes.end(), key) != axes.end()) {
      const double count = words.number();
      if (!(count >= 1 && count <= 1e6)) throw BadInput("{}: {} {}: must be a count", place, key, shortest(count));
      for (int k = 0; k < static_cast<int>(count); ++k) lists[key].push_back(words.number());
    } else if (key == "ScatterType") {
      words.expect("BRDF");
    } else if (key == "Source" || key == "Symmetry" || key == "SpectralContent") {
      words.word();
    } else if (key == "Monochrome" || key.starts_with("Tristimulus")) {
      for (const auto axis : axes)
        if (lists[std::string(axis)].empty()) throw BadInput("{}: {} is missing before the data", place, axis);
      measurement.channels.push_back(key == "Monochrome" ? "" : key);
      words.expect("DataBegin");
      for (std::size_t rotation = 0; rotation < lists["SampleRotation"].size(); ++rotation)
        for (const double theta_i : lists["AngleOfIncidence"]) {
          if (!(theta_i >= 0 && theta_i < 90))
            throw BadInput("{}: AngleOfIncidence {}: must be a number from 0 to below 90 degrees", place, shortest(theta_i));
          words.expect("TIS");
          words.number();
          for (const double azimuth : lists["ScatterAzimuth"])
            for (const double radial : lists["ScatterRadial"]) {
              const double brdf = words.number();
              const auto [theta_s, phi] = scattered(theta_i, radial, azimuth);
              if (theta_s < 90)
                measurement.samples.push_back(
                    {.pair = {theta_i, theta_s, phi, words.line()}, .brdf = brdf, .channel = measurement.channels.size() - 1});
              else
                below_horizon += brdf != 0;
            }
        }
      words.expect("DataEnd");
    } else {
      throw BadInput("{}: {}: is no keyword of a Zemax tabular BSDF", place, excerpt(key));
    }
  }
  if (below_horizon > 0)
    measurement.warnings.push_back(fmt::format("{} values above 0 lie below the horizon: set aside", below_horizon));
  if (lists["SampleRotation"].size() > 1)
    measurement.warnings.push_back(
        fmt::format("{} rotations of the sample are taken as one isotropic surface", lists["SampleRotation"].size()));
  return measurement;
}

}  // namespace brdftab

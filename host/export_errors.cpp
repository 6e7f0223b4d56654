#include "host/export_errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "host/error.hpp"
#include "host/surface_vector.hpp"

namespace brdftab {
namespace {

using Channels = std::vector<std::vector<double>>;

constexpr double degrees_per_radian = 180 / std::numbers::pi;
// A file may go to 90 degrees; the model stops short of them.
constexpr double largest_theta = 89.9;

double portion(std::vector<double>& values, double share) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

class Draw {
 public:
  explicit Draw(const ExportedTable& table)
      : last_i_(std::min(table.largest_theta_i(), largest_theta)), last_s_(std::min(table.largest_theta_s(), largest_theta)) {}

  Directions uniform(std::size_t count) {
    Directions result;
    for (std::size_t k = 0; k < count; ++k) result.add(theta(last_i_), theta(last_s_), between(-180, 180));
    return result;
  }

  // Half of them about the mirror direction, half about that of the light.
  Directions near_peaks(std::size_t count) {
    Directions result;
    while (result.size() < count) {
      const double theta_i = theta(std::min(last_i_, last_s_));
      const double distance = std::pow(10, between(-3, std::log10(30)));
      const SurfaceVector at = about_specular(theta_i, distance, between(-180, 180));
      // A grid that ends near the normal has few of them: its rim stands for those beyond.
      result.add(theta_i, std::min(at.theta(), last_s_), at.phi() + (result.size() % 2 ? 180 : 0));
    }
    return result;
  }

 private:
  double between(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double theta(double last) { return std::acos(between(std::cos(last / degrees_per_radian), 1)) * degrees_per_radian; }

  double last_i_, last_s_;
  std::mt19937_64 random_{20'080'818};
};

Channels expected(const ExportedTable& table, const ExportSource& source, const Directions& directions) {
  Channels f = source.evaluate(directions);
  if (table.channels() == ExportChannels::rgb) return source.rgb(f);
  if (table.channels() == ExportChannels::xyz) return source.xyz(f);
  return f;
}

ConsumerError compare(const Channels& consumer, const Channels& model, const Directions& directions) {
  if (consumer.size() != model.size())
    throw BadInput("the file has {} channels, and its material {}", consumer.size(), model.size());
  ConsumerError result;
  std::vector<double> errors;
  result.maximum = -1;
  for (std::size_t c = 0; c < model.size(); ++c)
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const double difference = std::abs(consumer[c][k] - model[c][k]) / std::max(model[c][k], error_floor);
      const double error = std::isnan(difference) ? INFINITY : difference;
      errors.push_back(error);
      if (!(error > result.maximum)) continue;
      result.maximum = error;
      result.theta_i = directions.theta_i[k];
      result.theta_s = directions.theta_s[k];
      result.phi = directions.phi[k];
      result.channel = c;
      result.consumer = consumer[c][k];
      result.model = model[c][k];
    }
  result.values = errors.size();
  result.maximum = std::max(result.maximum, 0.);
  result.median = portion(errors, 0.5);
  result.percentile_95 = portion(errors, 0.95);
  return result;
}

// Median and maximum of what `of` gives for two values of f.
template <class Of>
std::pair<double, double> spread(const Channels& a, const Channels& b, Of of) {
  std::vector<double> values;
  for (std::size_t band = 0; band < a.size(); ++band)
    for (std::size_t k = 0; k < a[band].size(); ++k)
      values.push_back(of(std::max(a[band][k], error_floor), std::max(b[band][k], error_floor)));
  const double median = portion(values, 0.5);
  return {median, portion(values, 1)};
}

std::string text(const ConsumerError& error) {
  return fmt::format("{:.2g} % in the median, {:.2g} % at 95 %, {:.3g} % at most (theta_i {:.4g}, theta_s {:.4g}, phi {:.4g})",
                     100 * error.median, 100 * error.percentile_95, 100 * error.maximum, error.theta_i, error.theta_s, error.phi);
}

}  // namespace

ExportErrors export_errors(const ExportedTable& table, const ExportSource& source, std::size_t directions) {
  Draw draw(table);
  const Directions uniform = draw.uniform(directions), near_peaks = draw.near_peaks(directions);
  ExportErrors result;
  result.uniform = compare(table.evaluate(uniform), expected(table, source, uniform), uniform);
  result.near_peaks = compare(table.evaluate(near_peaks), expected(table, source, near_peaks), near_peaks);
  std::tie(result.reciprocity_median, result.reciprocity_maximum) =
      spread(source.evaluate(uniform), source.evaluate(exchanged(uniform)),
             [](double a, double b) { return std::abs(std::log(a / b)); });
  std::tie(result.polarization_median, result.polarization_maximum) =
      spread(source.evaluate(uniform, Polarization::s), source.evaluate(uniform, Polarization::p),
             [](double s, double p) { return std::abs(s - p) / (s + p); });
  return result;
}

std::string summary(const ExportErrors& errors, const ExportFormat& format, const ExportedTable& table) {
  std::string line = fmt::format("read by {}, f is off by {} at {} random values; near the mirror and retro directions by {}",
                                 table.interpolation(), text(errors.uniform), errors.uniform.values, text(errors.near_peaks));
  if (!format.traits().holds_non_reciprocal)
    line += fmt::format("; not held: |ln f(i,s)/f(s,i)|, {:.2g} in the median, {:.2g} at most", errors.reciprocity_median,
                        errors.reciprocity_maximum);
  if (!format.traits().holds_polarization)
    line += fmt::format("; not held: polarisation, |f_s - f_p|/(f_s + f_p) {:.2g} in the median, {:.2g} at most",
                        errors.polarization_median, errors.polarization_maximum);
  return line;
}

}  // namespace brdftab

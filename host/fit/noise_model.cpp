#include "host/fit/noise_model.hpp"

#include <boost/math/tools/minima.hpp>

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::string_view allowed =
    "must be RELATIVE,FLOOR, the relative noise as 2% or 0.02 and the constant one in 1/sr above 0, either "
    "of them or both 'estimated'";
// A search for a logarithm looks at a grid of this many points and refines the best.
constexpr int grid_points = 64;
constexpr int digits = 24;  // binary
// Beyond this ratio to the other part of the noise, a part does not matter to any sample.
constexpr double negligible = 1e-3;

std::optional<double> part(const std::string& text, std::string_view word, bool may_be_percent) {
  if (word == "estimated") return std::nullopt;
  const bool is_percent = may_be_percent && word.ends_with('%');
  if (is_percent) word.remove_suffix(1);
  const auto value = parse_number(trimmed(word));
  if (!value || !std::isfinite(*value) || *value < 0)
    throw BadInput(GivenValue{"noise", excerpt(text)}, "{}", allowed);
  return is_percent ? *value / 100 : *value;
}

// Finds the value in [low, high] that makes `minus_log_likelihood` least; the search is in its logarithm.
template <class Function>
double most_likely(double low, double high, const Function& minus_log_likelihood) {
  const double from = std::log(low), step = (std::log(high) - from) / grid_points;
  const auto at = [&](double logarithm) { return minus_log_likelihood(std::exp(logarithm)); };
  double best = from, least = at(from);
  for (int k = 1; k <= grid_points; ++k)
    if (const double value = at(from + k * step); value < least) {
      best = from + k * step;
      least = value;
    }
  return std::exp(boost::math::tools::brent_find_minima(at, best - step, best + step, digits).first);
}

// The samples of one fit: f of the model, data - f, and 1 - leverage.
struct Samples {
  std::span<const double> f, errors, freedom;
};

// This is -2 ln of the likelihood, up to a constant.
double misfit(const NoiseModel& noise, const Samples& samples) {
  const auto& [f, errors, freedom] = samples;
  double sum = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    const double sigma = noise.sigma(f[k]);
    sum += 2 * freedom[k] * std::log(sigma) + errors[k] * errors[k] / (sigma * sigma);
  }
  return sum;
}

}  // namespace

double NoiseModel::sigma(double f) const { return std::hypot(relative * f, floor); }

NoiseChoice noise_choice(const std::string& text) {
  if (trimmed(text) == "estimated") return {};
  const auto comma = text.find(',');
  if (comma == std::string::npos) throw BadInput(GivenValue{"noise", excerpt(text)}, "{}", allowed);
  const std::string_view words = text;
  const NoiseChoice choice{.relative = part(text, trimmed(words.substr(0, comma)), true),
                           .floor = part(text, trimmed(words.substr(comma + 1)), false)};
  if (choice.floor == 0. || choice.relative > 1.)
    throw BadInput(GivenValue{"noise", excerpt(text)}, "{}", allowed);
  return choice;
}

NoiseModel estimated_noise(const NoiseChoice& choice, std::span<const double> f,
                           std::span<const double> errors, std::span<const double> freedom) {
  if (choice.is_given()) return {*choice.relative, *choice.floor};
  const Samples samples{f, errors, freedom};
  double free = 0, largest = 0, smallest = HUGE_VAL, squares = 0;
  for (std::size_t k = 0; k < f.size(); ++k) {
    largest = std::max(largest, f[k]);
    smallest = std::min(smallest, f[k]);
    squares += errors[k] * errors[k];
    free += freedom[k];
  }
  const double rms = std::max(std::sqrt(squares / static_cast<double>(f.size())), 1e-12 * largest);
  if (choice.floor) {
    const auto given = [&](double relative) { return NoiseModel{relative, *choice.floor}; };
    const double low = negligible * std::min(*choice.floor / largest, 1.);
    return given(most_likely(low, 10, [&](double relative) { return misfit(given(relative), samples); }));
  }
  if (choice.relative) {
    const auto given = [&](double floor) { return NoiseModel{*choice.relative, floor}; };
    const double low = negligible * std::min(rms, std::max(*choice.relative, 1e-6) * smallest + 1e-6 * rms);
    return given(most_likely(low, 10 * rms, [&](double floor) { return misfit(given(floor), samples); }));
  }
  // The most likely scale of both follows from their ratio.
  const auto of_ratio = [&](double ratio) {
    double sum = 0;
    for (std::size_t k = 0; k < f.size(); ++k) sum += errors[k] * errors[k] / (f[k] * f[k] + ratio * ratio);
    const double relative = std::max(std::sqrt(sum / free), 1e-12);
    return NoiseModel{relative, relative * ratio};
  };
  return of_ratio(most_likely(negligible * std::max(smallest, 1e-6 * largest), largest / negligible,
                              [&](double ratio) { return misfit(of_ratio(ratio), samples); }));
}

std::string noise_text(const NoiseModel& noise, const NoiseChoice& choice) {
  const auto how = [](bool given) { return given ? "given" : "estimated"; };
  return fmt::format("sigma^2 = (a f)^2 + b^2 with f of the model, a = {:.4g} {}, b = {:.4g} 1/sr {}",
                     noise.relative, how(choice.relative.has_value()), noise.floor,
                     how(choice.floor.has_value()));
}

}  // namespace brdftab

#include "host/fit/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"

namespace brdftab {
namespace {

// Where a noise model is estimated, the first descents begin with these parts: of f, and of the median
// modulus of the data.
constexpr double first_relative_noise = 0.05;
constexpr double first_floor = 0.1;
// The Cauchy loss is 95 % efficient for normal residuals where its scale is 2.385 of their standard
// deviation, which is 1.4826 of their median modulus.
constexpr double cauchy_scale = 2.385 * 1.4826;
// A model that meets the data exactly leaves residuals without a scale of their own.
constexpr double smallest_median = 1e-6;

}  // namespace

FitProblem::FitProblem(const Engine& engine, const Measurement& measurement, const FitOptions& options)
    : options_(options) {
  take_samples(measurement);
  make_variables();
  if (variables_.empty())
    throw BadInput("{}: every parameter is fixed: there is nothing to fit", measurement.source);
  if (samples_ <= variables_.size())
    throw BadInput("{}: {} samples are left for {} free parameters ({} beyond {} degrees, {} below {} 1/sr)",
                   measurement.source, samples_, variables_.size(), beyond_max_theta_,
                   shortest(options.max_theta), below_floor_, shortest(options.floor));
  if (options.weights == FitWeights::sigma && !measurement.has_sigma())
    throw BadInput("{}: `weights` sigma takes a column sigma with a value in every row", measurement.source);
  weigh();
  mean_of_exchanges_ = measurement.mean_of_exchanges;
  if (options.take_sigma()) guess_sigma();
  std::vector<LogBrdfGradients> gradients;
  for (const FitBand& band : bands_) gradients.push_back(gradients_at(engine, band.samples));
  batch_ = std::make_unique<GradientBatch>(std::move(gradients), mean_of_exchanges_);
}

LogBrdfGradients FitProblem::gradients_at(const Engine& engine,
                                          const std::vector<MeasuredSample>& samples) const {
  std::vector<DirectionPair> pairs;
  std::vector<double> shares;
  for (const auto& sample : samples) {
    pairs.push_back(sample.pair);
    shares.push_back(sample.share_s);
  }
  if (mean_of_exchanges_) {
    pairs = with_exchanges(std::move(pairs));
    for (std::size_t k = 0; k < samples.size(); ++k) shares.push_back(shares[k]);
  }
  return {engine, pairs, shares, options_.variant};
}

LogBrdfValues FitProblem::values_at(const Engine& engine, const std::vector<MeasuredSample>& samples,
                                    const Parameters& parameters) const {
  LogBrdfValues values = gradients_at(engine, samples).evaluate({&parameters, 1});
  return mean_of_exchanges_ ? values.mean_of_exchanges(1) : values;
}

void FitProblem::take_samples(const Measurement& measurement) {
  const Incidences all = measurement.incidences();
  std::vector<double> used;
  for (std::size_t c = 0; c < measurement.channels.size(); ++c) {
    bands_.push_back({measurement.channels[c], measurement.wavelength_nm(c), {}, {}, {}, {}});
    for (const auto& sample : measurement.samples) {
      if (sample.channel != c) continue;
      // An encoder reads part of a setting at the limit back as just beyond it: the setting is used whole.
      const double theta_i = all.lowest(all.index(sample.pair.theta_i));
      const bool beyond = std::max(theta_i, sample.pair.model_theta_s()) > options_.max_theta;
      const bool below = !options_.take_sigma() && !(sample.brdf > options_.floor);
      beyond_max_theta_ += beyond;
      below_floor_ += !beyond && below;
      if (beyond) continue;
      (below ? bands_.back().below_floor : bands_.back().samples).push_back(sample);
      if (!below) used.push_back(sample.pair.theta_i);
    }
    samples_ += bands_.back().samples.size();
    if (bands_.back().samples.empty())
      throw BadInput("{}: no sample of channel {} lies within {} degrees and above {} 1/sr",
                     measurement.source, excerpt(measurement.channels[c]), shortest(options_.max_theta),
                     shortest(options_.floor));
  }
  incidence_width_ = measurement.incidence_width;
  incidences_.emplace(used, incidence_width_);
}

bool FitProblem::is_of_one_light() const {
  const double first = bands_.front().samples.front().share_s;
  return std::all_of(bands_.begin(), bands_.end(), [&](const FitBand& band) {
    return std::all_of(band.samples.begin(), band.samples.end(),
                       [&](const auto& sample) { return sample.share_s == first; });
  });
}

double FitProblem::share_s() const {
  return is_of_one_light() ? bands_.front().samples.front().share_s : 0.5;
}

void FitProblem::weigh() {
  double sum = 0;
  for (FitBand& band : bands_) {
    std::vector<double> count(incidences_->size());
    for (const auto& sample : band.samples) ++count[incidences_->index(sample.pair.theta_i)];
    for (const auto& sample : band.samples) {
      double weight = 1;
      if (options_.weights == FitWeights::aoi && !options_.take_sigma())
        weight = 1 / count[incidences_->index(sample.pair.theta_i)];
      band.weights.push_back(weight);
      sum += weight;
    }
  }
  for (FitBand& band : bands_)
    for (double& weight : band.weights) weight *= static_cast<double>(samples_) / sum;
}

// A fit needs sigmas before it has a model. With a noise model they come from the data, until update_noise
// has f of a model.
void FitProblem::guess_sigma() {
  if (options_.noise) {
    std::vector<double> sizes;
    double mean = 0;
    for (const FitBand& band : bands_)
      for (const auto& sample : band.samples) sizes.push_back(std::abs(sample.brdf));
    for (const double size : sizes) mean += size / static_cast<double>(sizes.size());
    const double middle = median(sizes);
    noise_ = {.relative = options_.noise->relative.value_or(first_relative_noise),
              .floor = options_.noise->floor.value_or(first_floor * (middle > 0 ? middle : mean))};
  }
  for (FitBand& band : bands_)
    for (const auto& sample : band.samples)
      band.sigma.push_back(noise_ ? noise_->sigma(std::max(sample.brdf, 0.)) : sample.sigma);
}

double FitProblem::update_noise(std::span<const double> u, std::span<const double> freedom) {
  const auto evaluated = batch_->evaluate(parameters(u));
  std::vector<double> f, errors;
  for (std::size_t b = 0; b < bands_.size(); ++b)
    for (std::size_t k = 0; k < bands_[b].samples.size(); ++k) {
      f.push_back(std::exp(evaluated[b].ln_f()[k]));
      errors.push_back(bands_[b].samples[k].brdf - f.back());
    }
  noise_ = estimated_noise(*options_.noise, f, errors, freedom);
  double change = 0;
  auto model = f.begin();
  for (FitBand& band : bands_)
    for (double& sigma : band.sigma) {
      const double updated = noise_->sigma(*model++);
      change = std::max(change, std::abs(updated / sigma - 1));
      sigma = updated;
    }
  return change;
}

void FitProblem::update_loss_scale(std::span<const double> u) {
  loss_scale_ = std::numeric_limits<double>::infinity();
  std::vector<double> moduli = residuals(u).values;
  for (double& value : moduli) value = std::abs(value);
  loss_scale_ = cauchy_scale * std::max(median(moduli), smallest_median);
}

void FitProblem::make_variables() {
  fixed_.resize(bands_.size());
  std::vector<std::size_t> all(bands_.size());
  for (std::size_t b = 0; b < all.size(); ++b) all[b] = b;
  for (std::size_t p = 0; p < parameter_table.size(); ++p) {
    const ParameterChoice& choice = options_.choices[p];
    if (choice.fixed) {
      for (Parameters& parameters : fixed_) parameters.*parameter_table[p].member = *choice.fixed;
    } else if (options_.share_geometry && parameter_table[p].is_geometric) {
      variables_.push_back({p, all, choice.minimum, choice.maximum});
    } else {
      for (const std::size_t b : all) variables_.push_back({p, {b}, choice.minimum, choice.maximum});
    }
  }
}

std::vector<Parameters> FitProblem::parameters(std::span<const double> u) const {
  std::vector<Parameters> result = fixed_;
  for (std::size_t v = 0; v < variables_.size(); ++v)
    for (const std::size_t b : variables_[v].bands)
      result[b].*variables_[v].row().member = variables_[v].from_solver(u[v]);
  return result;
}

std::vector<double> FitProblem::solver_variables(std::span<const Parameters> bands) const {
  std::vector<double> u;
  for (const FitVariable& v : variables_)
    u.push_back(v.to_solver(std::clamp(bands[v.bands.front()].*v.row().member, v.minimum, v.maximum)));
  return u;
}

SampleRanges FitProblem::sample_ranges() const {
  SampleRanges ranges{{90, 0}, {90, 0}, {HUGE_VAL, -HUGE_VAL}};
  const auto extend = [](FitRange& range, double value) {
    range = {std::min(range.low, value), std::max(range.high, value)};
  };
  for (const FitBand& band : bands_)
    for (const auto& sample : band.samples) {
      extend(ranges.theta_i, sample.pair.theta_i);
      extend(ranges.theta_s, sample.pair.model_theta_s());
      extend(ranges.brdf, sample.brdf);
    }
  return ranges;
}

std::vector<double> FitProblem::log_ratios(const BandValues& values, std::size_t band) const {
  std::vector<double> ratios;
  const auto ln_f = values.ln_f();
  for (std::size_t k = 0; k < bands_[band].samples.size(); ++k) {
    const double datum = bands_[band].samples[k].brdf;
    ratios.push_back(datum > 0 ? ln_f[k] - std::log(datum) : std::numeric_limits<double>::quiet_NaN());
  }
  return ratios;
}

std::vector<double> FitProblem::misfits(const BandValues& values, std::size_t band) const {
  const FitBand& data = bands_[band];
  if (!options_.take_sigma()) return log_ratios(values, band);
  std::vector<double> result;
  for (std::size_t k = 0; k < data.samples.size(); ++k)
    result.push_back((std::exp(values.ln_f()[k]) - data.samples[k].brdf) / data.sigma[k]);
  return result;
}

double FitProblem::unit(std::size_t band, std::size_t sample) const {
  return options_.take_sigma() ? bands_[band].sigma[sample] : bands_[band].samples[sample].brdf;
}

FitProblem::Residuals FitProblem::residuals(std::span<const double> u) const {
  const auto evaluated = batch_->evaluate(parameters(u));
  const std::size_t columns = variables_.size();
  Residuals result{.values = {}, .jacobian = std::vector<double>(samples_ * columns), .cost = 0};
  result.values.reserve(samples_);
  std::vector<double> factors;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const auto values = misfits(evaluated[b], b);
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double root = std::sqrt(bands_[b].weights[k]);
      double value = root * values[k];
      // This is the derivative of the misfit by ln f.
      double slope = root;
      if (options_.take_sigma()) slope *= std::exp(evaluated[b].ln_f()[k]) / bands_[b].sigma[k];
      // Ceres applies a loss to a whole block only; so each residual becomes c sqrt(ln(1 + r^2/c^2)).
      if (std::isfinite(loss_scale_) && value != 0) {
        const double squared = value * value / (loss_scale_ * loss_scale_);
        const double robust = std::copysign(loss_scale_ * std::sqrt(std::log1p(squared)), value);
        slope *= value / (robust * (1 + squared));
        value = robust;
      }
      result.values.push_back(value);
      result.cost += value * value;
      factors.push_back(slope);
    }
  }
  if (!std::isfinite(result.cost)) result.cost = std::numeric_limits<double>::infinity();
  std::size_t first = 0;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const std::size_t count = bands_[b].samples.size();
    for (std::size_t v = 0; v < columns; ++v) {
      const auto& owners = variables_[v].bands;
      if (owners.size() == 1 ? owners.front() != b
                             : std::find(owners.begin(), owners.end(), b) == owners.end())
        continue;
      const double slope = variables_[v].slope(u[v]);
      const auto by = evaluated[b].by(variables_[v].parameter);
      for (std::size_t k = 0; k < count; ++k) {
        double& entry = result.jacobian[(first + k) * columns + v];
        entry = factors[first + k] * by[k] * slope;
        if (!std::isfinite(entry)) result.cost = std::numeric_limits<double>::infinity();
      }
    }
    first += count;
  }
  return result;
}

FitProblem::LogRms FitProblem::log_rms(std::span<const double> u) const {
  const auto evaluated = batch_->evaluate(parameters(u));
  std::map<std::pair<std::size_t, std::size_t>, std::pair<double, double>> sums;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const auto ratios = log_ratios(evaluated[b], b);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      if (!(bands_[b].samples[k].brdf > options_.floor)) continue;
      auto& [squares, count] = sums[{b, incidences_->index(bands_[b].samples[k].pair.theta_i)}];
      squares += ratios[k] * ratios[k];
      ++count;
    }
  }
  double of_means = 0, of_all = 0, samples = 0;
  for (const auto& [key, value] : sums) {
    of_means += value.first / value.second;
    of_all += value.first;
    samples += value.second;
  }
  return {std::sqrt(of_all / samples), std::sqrt(of_means / static_cast<double>(sums.size())),
          static_cast<std::size_t>(samples)};
}

}  // namespace brdftab

#include "host/fit_problem.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "host/error.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// rho, w_a, w_b, gamma, delta, w and n follow from the surface's geometry, not from the wavelength.
bool is_geometric(std::size_t parameter) {
  const auto name = parameter_table[parameter].name;
  return name.starts_with("rho") || parameter >= 8;
}

}  // namespace

FitProblem::FitProblem(const Engine& engine, const Measurement& measurement, const FitOptions& options) : options_(options) {
  take_samples(measurement);
  make_variables();
  if (variables_.empty()) throw BadInput("{}: every parameter is fixed: there is nothing to fit", measurement.source);
  if (samples_ <= variables_.size())
    throw BadInput("{}: {} samples are left for {} free parameters ({} beyond {} degrees, {} below {} 1/sr)", measurement.source,
                   samples_, variables_.size(), beyond_max_theta_, shortest(options.max_theta), below_floor_,
                   shortest(options.floor));
  if (options.weights == FitWeights::sigma && !measurement.has_sigma())
    throw BadInput("{}: --weights sigma takes a column sigma with a value in every row", measurement.source);
  weigh();
  std::vector<std::vector<DirectionPair>> pairs;
  for (const FitBand& band : bands_) {
    pairs.emplace_back();
    for (const auto& sample : band.samples) pairs.back().push_back(sample.pair);
  }
  batch_ = std::make_unique<GradientBatch>(engine, pairs, options.share_s, options.switches, measurement.mean_of_exchanges);
}

void FitProblem::take_samples(const Measurement& measurement) {
  const Incidences all = measurement.incidences();
  std::vector<double> used;
  for (std::size_t c = 0; c < measurement.channels.size(); ++c) {
    bands_.push_back({measurement.channels[c], measurement.wavelength_nm(c), {}, {}});
    for (const auto& sample : measurement.samples) {
      if (sample.channel != c) continue;
      // Of a setting at the limit, what an encoder reads back just beyond it belongs to the rest.
      const double theta_i = all.lowest(all.index(sample.pair.theta_i));
      const bool beyond = std::max(theta_i, sample.pair.model_theta_s()) > options_.max_theta;
      const bool below = !(sample.brdf > options_.floor);
      beyond_max_theta_ += beyond;
      below_floor_ += !beyond && below;
      if (beyond || below) continue;
      bands_.back().samples.push_back(sample);
      used.push_back(sample.pair.theta_i);
    }
    samples_ += bands_.back().samples.size();
    if (bands_.back().samples.empty())
      throw BadInput("{}: no sample of channel {} lies within {} degrees and above {} 1/sr", measurement.source,
                     excerpt(measurement.channels[c]), shortest(options_.max_theta), shortest(options_.floor));
  }
  incidences_.emplace(used, measurement.incidence_width);
}

void FitProblem::weigh() {
  double sum = 0;
  for (FitBand& band : bands_) {
    std::vector<double> count(incidences_->size());
    for (const auto& sample : band.samples) ++count[incidences_->index(sample.pair.theta_i)];
    for (const auto& sample : band.samples) {
      double weight = 1;
      if (options_.weights == FitWeights::aoi) weight = 1 / count[incidences_->index(sample.pair.theta_i)];
      if (options_.weights == FitWeights::sigma) weight = std::pow(sample.brdf / sample.sigma, 2);
      band.weights.push_back(weight);
      sum += weight;
    }
  }
  for (FitBand& band : bands_)
    for (double& weight : band.weights) weight *= static_cast<double>(samples_) / sum;
}

void FitProblem::make_variables() {
  fixed_.resize(bands_.size());
  std::vector<std::size_t> all(bands_.size());
  for (std::size_t b = 0; b < all.size(); ++b) all[b] = b;
  for (std::size_t p = 0; p < parameter_table.size(); ++p) {
    const ParameterChoice& choice = options_.choices[p];
    if (choice.fixed) {
      for (Parameters& parameters : fixed_) parameters.*parameter_table[p].member = *choice.fixed;
    } else if (options_.share_geometry && is_geometric(p)) {
      variables_.push_back({p, all, choice.minimum, choice.maximum});
    } else {
      for (const std::size_t b : all) variables_.push_back({p, {b}, choice.minimum, choice.maximum});
    }
  }
}

std::vector<Parameters> FitProblem::parameters(std::span<const double> u) const {
  std::vector<Parameters> result = fixed_;
  for (std::size_t v = 0; v < variables_.size(); ++v)
    for (const std::size_t b : variables_[v].bands) result[b].*variables_[v].row().member = variables_[v].from_solver(u[v]);
  return result;
}

std::vector<double> FitProblem::solver_variables(std::span<const Parameters> bands) const {
  std::vector<double> u;
  for (const FitVariable& v : variables_)
    u.push_back(v.to_solver(std::clamp(bands[v.bands.front()].*v.row().member, v.minimum, v.maximum)));
  return u;
}

std::vector<double> FitProblem::log_ratios(const BandValues& values, std::size_t band) const {
  std::vector<double> ratios;
  const auto ln_f = values.ln_f();
  for (std::size_t k = 0; k < bands_[band].samples.size(); ++k)
    ratios.push_back(ln_f[k] - std::log(bands_[band].samples[k].brdf));
  return ratios;
}

FitProblem::Residuals FitProblem::residuals(std::span<const double> u) const {
  const auto evaluated = batch_->evaluate(parameters(u));
  const std::size_t columns = variables_.size();
  Residuals result{.values = {}, .jacobian = std::vector<double>(samples_ * columns), .cost = 0};
  result.values.reserve(samples_);
  std::vector<double> factors;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const auto ratios = log_ratios(evaluated[b], b);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      const double root = std::sqrt(bands_[b].weights[k]);
      double value = root * ratios[k];
      double slope = root;
      // Ceres takes a loss of a whole block only; as a residual it is c sqrt(ln(1 + r^2/c^2)).
      if (std::isfinite(loss_scale) && value != 0) {
        const double squared = value * value / (loss_scale * loss_scale);
        const double robust = std::copysign(loss_scale * std::sqrt(std::log1p(squared)), value);
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
      if (owners.size() == 1 ? owners.front() != b : std::find(owners.begin(), owners.end(), b) == owners.end()) continue;
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

double FitProblem::rms(std::span<const double> u) const {
  const auto evaluated = batch_->evaluate(parameters(u));
  std::map<std::pair<std::size_t, std::size_t>, std::pair<double, double>> sums;
  for (std::size_t b = 0; b < bands_.size(); ++b) {
    const auto ratios = log_ratios(evaluated[b], b);
    for (std::size_t k = 0; k < ratios.size(); ++k) {
      auto& [squares, count] = sums[{b, incidences_->index(bands_[b].samples[k].pair.theta_i)}];
      squares += ratios[k] * ratios[k];
      ++count;
    }
  }
  double sum = 0;
  for (const auto& [key, value] : sums) sum += value.first / value.second;
  return std::sqrt(sum / static_cast<double>(sums.size()));
}

}  // namespace brdftab

// The least-squares problem of a fit: samples with weights, variables with bounds, residuals and their
// derivatives.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "host/fit/fit_variable.hpp"
#include "host/fit/gradient_batch.hpp"
#include "host/fit/noise_model.hpp"
#include "host/model/material/fit_record.hpp"
#include "host/model/measurement/measurement.hpp"

namespace brdftab {

enum class FitWeights { aoi, uniform, sigma };
enum class FitLoss { linear, cauchy };

struct FitOptions {
  std::vector<ParameterChoice> choices = default_choices();
  std::size_t starts = 48;
  std::uint64_t seed = 1;
  /// Samples whose theta_i or theta_s lies beyond it, in degrees, are left out.
  double max_theta = 80;
  /// Samples with f at or below it, in 1/sr, are left out where residuals are ln(model/data).
  double floor = 2e-3;
  FitWeights weights = FitWeights::aoi;
  /// Where it is given, it takes the place of weights: each sample gets its sigma from it.
  std::optional<NoiseChoice> noise;

  /// Whether residuals are (model - data)/sigma, over all samples, and not ln(model/data).
  bool take_sigma() const { return noise.has_value() || weights == FitWeights::sigma; }
  FitLoss loss = FitLoss::linear;
  /// Whether the channels of a spectrum have the parameters in common that are geometric.
  bool share_geometry = true;
  Variant variant;
};

/// The samples of one channel that a fit uses.
struct FitBand {
  std::string channel;
  std::optional<double> wavelength_nm;
  std::vector<MeasuredSample> samples;
  /// These lie within max_theta but have f at or below the floor.
  std::vector<MeasuredSample> below_floor;
  /// The sigma of each sample, 1/sr; there are none where residuals are ln(model/data).
  std::vector<double> sigma;
  /// The weight of each residual; the mean of all bands' weights is 1.
  std::vector<double> weights;
};

/// The lowest and highest of the samples that a fit uses.
struct SampleRanges {
  FitRange theta_i, theta_s;  // degrees
  FitRange brdf;              // 1/sr
};

class FitProblem {
 public:
  /// Each channel of the measurement is a band. Throws BadInput where too little is left to fit.
  FitProblem(const Engine& engine, const Measurement& measurement, const FitOptions& options);

  const std::vector<FitBand>& bands() const { return bands_; }
  const std::vector<FitVariable>& variables() const { return variables_; }
  /// The settings of theta_i that the samples of all bands together have.
  const Incidences& incidences() const { return *incidences_; }
  double incidence_width() const { return incidence_width_; }
  std::size_t samples() const { return samples_; }
  SampleRanges sample_ranges() const;
  /// The share of s-polarised light that all samples have; it is 1/2 where they differ.
  double share_s() const;
  bool is_of_one_light() const;
  /// How many samples max_theta left out, and how many the floor.
  std::size_t beyond_max_theta() const { return beyond_max_theta_; }
  std::size_t below_floor() const { return below_floor_; }
  const GradientBatch& batch() const { return *batch_; }
  const FitOptions& options() const { return options_; }

  /// The noise model that gave the sigmas in force; none where the data give them.
  const std::optional<NoiseModel>& noise() const { return noise_; }
  /// Estimates what is not given of the noise model, and sets each sample's sigma by it, with f of the model
  /// at u; `freedom` is 1 - leverage of each sample there. Returns the largest relative change of a sigma.
  double update_noise(std::span<const double> u, std::span<const double> freedom);

  /// Sets the scale of the Cauchy loss by the median modulus of the residuals at u. Before, it has none.
  void update_loss_scale(std::span<const double> u);

  std::vector<Parameters> parameters(std::span<const double> u) const;
  std::vector<double> solver_variables(std::span<const Parameters> bands) const;

  /// Each value is sqrt(weight) times the misfit, with the loss applied; the Jacobian has its derivatives by
  /// the solver's variables, row-major.
  struct Residuals {
    std::vector<double> values;
    std::vector<double> jacobian;
    /// The sum of the squares; it is infinite where the model is not a number.
    double cost;
  };
  Residuals residuals(std::span<const double> u) const;

  /// The misfits of one band: ln(model/data) or, where the fit takes sigma, (model - data)/sigma.
  std::vector<double> misfits(const BandValues& values, std::size_t band) const;
  /// A misfit divides f by this: the datum or its sigma, 1/sr.
  double unit(std::size_t band, std::size_t sample) const;
  /// ln(model/data) of one band; it is nan where the datum is not above 0.
  std::vector<double> log_ratios(const BandValues& values, std::size_t band) const;
  /// The rms of ln(model/data) over the samples above the floor: each sample counts alike, or each setting of
  /// theta_i of each band does. Both are nan where no sample is above the floor.
  struct LogRms {
    double of_samples, of_incidences;
    std::size_t samples;
  };
  LogRms log_rms(std::span<const double> u) const;

  /// Evaluates ln f of a material and its derivatives at the directions of the samples, in the light of each,
  /// and as the mean of f(i, s) and f(s, i) where the measurement holds such means.
  LogBrdfValues values_at(const Engine& engine, const std::vector<MeasuredSample>& samples,
                          const Parameters& parameters) const;

 private:
  LogBrdfGradients gradients_at(const Engine& engine, const std::vector<MeasuredSample>& samples) const;
  void take_samples(const Measurement& measurement);
  void weigh();
  void guess_sigma();
  void make_variables();

  FitOptions options_;
  std::vector<FitBand> bands_;
  std::optional<Incidences> incidences_;
  double incidence_width_ = 0;
  bool mean_of_exchanges_ = false;
  std::vector<FitVariable> variables_;
  std::vector<Parameters> fixed_;
  std::optional<NoiseModel> noise_;
  std::size_t samples_ = 0;
  std::size_t beyond_max_theta_ = 0;
  std::size_t below_floor_ = 0;
  std::unique_ptr<GradientBatch> batch_;
  // The scale of the Cauchy loss, in units of the residuals; where it is infinite there is no loss.
  double loss_scale_ = std::numeric_limits<double>::infinity();
};

}  // namespace brdftab

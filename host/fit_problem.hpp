// The least-squares problem of a fit: samples with weights, variables with bounds, residuals and their derivatives.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "host/fit_variable.hpp"
#include "host/gradient_batch.hpp"
#include "host/measurement.hpp"

namespace brdftab {

enum class FitWeights { aoi, uniform, sigma };
enum class FitLoss { linear, cauchy };

struct FitOptions {
  std::vector<ParameterChoice> choices = default_choices();
  /// The part of s-polarised light in the measurement; 1/2: unpolarised.
  double share_s = 0.5;
  std::size_t starts = 48;
  std::uint64_t seed = 1;
  /// Samples beyond it, in degrees, or with f below the floor, in 1/sr, are left out.
  double max_theta = 80;
  double floor = 2e-3;
  FitWeights weights = FitWeights::aoi;
  FitLoss loss = FitLoss::linear;
  /// Between the channels of a spectrum: rho, V and V_m; otherwise nothing.
  bool share_geometry = true;
  ModelSwitches switches;
};

/// The samples of one channel that a fit uses.
struct FitBand {
  std::string channel;
  std::optional<double> wavelength_nm;
  std::vector<MeasuredSample> samples;
  /// Of each residual; their mean over all bands is 1.
  std::vector<double> weights;
};

class FitProblem {
 public:
  /// Each channel of the measurement is a band. Throws BadInput where too little is left to fit.
  FitProblem(const Engine& engine, const Measurement& measurement, const FitOptions& options);

  const std::vector<FitBand>& bands() const { return bands_; }
  const std::vector<FitVariable>& variables() const { return variables_; }
  /// The settings of theta_i among the samples, of all bands together.
  const Incidences& incidences() const { return *incidences_; }
  std::size_t samples() const { return samples_; }
  /// Samples left out by max_theta and by the floor.
  std::size_t beyond_max_theta() const { return beyond_max_theta_; }
  std::size_t below_floor() const { return below_floor_; }
  GradientBatch& batch() const { return *batch_; }
  const FitOptions& options() const { return options_; }

  /// Scale of the Cauchy loss, in ln f; infinite: no loss.
  double loss_scale = std::numeric_limits<double>::infinity();

  std::vector<Parameters> parameters(std::span<const double> u) const;
  std::vector<double> solver_variables(std::span<const Parameters> bands) const;

  /// sqrt(weight) ln(model/data), with the loss applied, and, row-major, its derivatives by the solver's variables.
  struct Residuals {
    std::vector<double> values;
    std::vector<double> jacobian;
    /// Sum of squares; infinite where the model is not a number.
    double cost;
  };
  Residuals residuals(std::span<const double> u) const;

  /// ln(model/data) of one band.
  std::vector<double> log_ratios(const BandValues& values, std::size_t band) const;
  /// Square root of the mean square of ln(model/data), over the means of each setting of theta_i of each band.
  double rms(std::span<const double> u) const;

 private:
  void take_samples(const Measurement& measurement);
  void weigh();
  void make_variables();

  FitOptions options_;
  std::vector<FitBand> bands_;
  std::optional<Incidences> incidences_;
  std::vector<FitVariable> variables_;
  std::vector<Parameters> fixed_;
  std::size_t samples_ = 0;
  std::size_t beyond_max_theta_ = 0;
  std::size_t below_floor_ = 0;
  std::unique_ptr<GradientBatch> batch_;
};

}  // namespace brdftab

// What a fit knows and does not know, gathered for people to read.
#pragma once

#include <string>
#include <vector>

#include "host/fit/fit.hpp"
#include "host/fit/uncertainty/fit_bias.hpp"
#include "host/fit/uncertainty/fit_sufficiency.hpp"

namespace brdftab {

struct FittedVariable {
  /// It is "rho_surface", or "n_eff[550]" where only one band has the variable.
  std::string name;
  double value;
  /// It is nan where the variable is at a bound or has no influence.
  double standard_error;
  Interval95 interval;
  bool at_bound;
  /// False where the variable is at its bound and the interval would come from a standard error.
  bool has_interval;

  bool unidentifiable() const { return has_interval && interval.open_below && interval.open_above; }
  /// Whether the data do not limit the interval on a side; at its bound nothing needs to limit it.
  bool lacks_lower_limit() const { return unidentifiable() || (interval.open_below && !at_bound); }
  bool lacks_upper_limit() const { return unidentifiable() || (interval.open_above && !at_bound); }
  /// Whether the data fix it to no better than a factor of two.
  bool poorly_known() const {
    return interval.open_below || interval.open_above || interval.high > 2 * interval.low;
  }
};

struct Correlation {
  std::string first;
  std::string second;
  double value;
};

/// How the fit agrees at a setting of theta_i or, where a list would be too long, at neighbouring ones.
struct IncidenceFit {
  std::string channel;
  /// The mean of the settings, the first and the last, in degrees.
  double theta_i, first, last;
  std::size_t samples;
  /// The rms of ln(model/data) or, where the fit takes sigma, of (model - data)/sigma.
  double rms;
  /// The DHR of the fitted material at theta_i, in the light of the measurement.
  double dhr;
};

struct FitSummary {
  Fit fit;
  std::vector<Parameters> bands;
  std::vector<FittedVariable> variables;
  LinearUncertainty linear;
  /// The strongest of all pairs.
  std::vector<Correlation> correlations;
  std::vector<IncidenceFit> incidences;
  std::vector<Sufficiency> sufficiency;
  FitProblem::LogRms log_rms;
  std::optional<LowReadingsLeftOut> low_readings;
  bool profiled;
};

/// With `profile`, intervals come by profile likelihood, otherwise from standard errors. A better fit that is
/// found on the way replaces fit.best.
FitSummary summarize(const Engine& engine, const FitProblem& problem, Fit fit, bool profile);

}  // namespace brdftab

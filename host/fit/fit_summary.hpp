// What a fit knows and does not know, gathered for people to read.
#pragma once

#include <string>
#include <vector>

#include "host/fit/fit.hpp"
#include "host/fit/fit_bias.hpp"
#include "host/fit/fit_sufficiency.hpp"

namespace brdftab {

struct FittedVariable {
  /// "rho_surface", or "n_eff[550]" where only one band has it.
  std::string name;
  double value;
  /// nan where it is at a bound or has no influence.
  double standard_error;
  Interval95 interval;
  bool at_bound;
  /// A standard error says nothing of a variable at its bound.
  bool has_interval;

  bool unidentifiable() const { return has_interval && interval.open_below && interval.open_above; }
  /// Within a factor of two at best.
  bool poorly_known() const {
    return interval.open_below || interval.open_above || interval.high > 2 * interval.low;
  }
};

struct Correlation {
  std::string first;
  std::string second;
  double value;
};

/// A setting of theta_i or, where there are too many for a list, neighbouring ones together.
struct IncidenceFit {
  std::string channel;
  /// Degrees: their mean, the first and the last.
  double theta_i, first, last;
  std::size_t samples;
  /// Of ln(model/data) or, where the fit takes sigma, of (model - data)/sigma.
  double rms;
  /// Of the fitted material at theta_i, in the light of the measurement.
  double dhr;
};

struct FitSummary {
  Fit fit;
  std::vector<Parameters> bands;
  std::vector<FittedVariable> variables;
  LinearUncertainty linear;
  /// The strongest.
  std::vector<Correlation> correlations;
  std::vector<IncidenceFit> incidences;
  std::vector<Sufficiency> sufficiency;
  FitProblem::LogRms log_rms;
  std::optional<LowReadingsLeftOut> low_readings;
  bool profiled;
};

/// `profile`: intervals by profile likelihood, else from standard errors. A better fit found on the way
/// replaces fit.best.
FitSummary summarize(const Engine& engine, const FitProblem& problem, Fit fit, bool profile);

/// Why a fit is not to be used, in words for everybody; empty where nothing speaks against it. The first line
/// of what follows.
std::string verdict(const FitProblem& problem, const FitSummary& summary);

/// The table on standard output.
std::string summary_text(const FitProblem& problem, const FitSummary& summary);

/// What a material file says besides its parameters.
struct MaterialHeading {
  std::string name;
  std::string description;
  std::string source;
  std::string command;
};

/// The material file (TOML), with the statistics as comments.
std::string material_text(const FitProblem& problem, const FitSummary& summary,
                          const MaterialHeading& heading);

}  // namespace brdftab

#include "host/fit/fitted_material.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/numbers.hpp"
#include "host/fit/fit_text.hpp"

namespace brdftab {
namespace {

constexpr double level = 0.95;

// Digits beyond what a number is known to would only be noise in a file.
double rounded(double value, int digits) { return *parse_number(fmt::format("{:.{}g}", value, digits)); }

FitRange rounded(const FitRange& range, int digits) {
  return {rounded(range.low, digits), rounded(range.high, digits)};
}

// There is none where the value is nan.
std::optional<double> optional_rounded(double value, int digits) {
  return std::isnan(value) ? std::nullopt : std::optional(rounded(value, digits));
}

FittedParameter fitted_parameter(const FittedVariable& fitted, const FitVariable& variable) {
  FittedParameter result{.interval = {},
                         .open_below = fitted.lacks_lower_limit(),
                         .open_above = fitted.lacks_upper_limit(),
                         .at_bound = fitted.at_bound,
                         .bounds = FitRange{variable.minimum, variable.maximum}};
  if (fitted.has_interval) result.interval = rounded({fitted.interval.low, fitted.interval.high}, 4);
  return result;
}

void add_parameters(FitRecord& record, const FitProblem& problem, const FitSummary& summary) {
  const std::size_t bands = problem.bands().size();
  record.bands.resize(bands);
  for (std::size_t v = 0; v < summary.variables.size(); ++v) {
    const FitVariable& variable = problem.variables()[v];
    const bool is_shared = variable.bands.size() == bands;
    FittedParameters& fitted = is_shared ? record.parameters : record.bands[variable.bands.front()];
    fitted[variable.parameter] = fitted_parameter(summary.variables[v], variable);
  }
  for (std::size_t p = 0; p < parameter_table.size(); ++p)
    if (problem.options().choices[p].fixed) record.fixed.emplace_back(parameter_table[p].name);
}

void add_samples(FitRecord& record, const FitProblem& problem) {
  const FitOptions& options = problem.options();
  const SampleRanges ranges = problem.sample_ranges();
  const double share_s = problem.share_s();
  record.light = !problem.is_of_one_light() ? "all" : share_s == 1 ? "s" : share_s == 0 ? "p" : "unpolarized";
  record.samples = problem.samples();
  record.theta_i = ranges.theta_i;
  record.theta_s = ranges.theta_s;
  record.brdf = rounded(ranges.brdf, 4);
  record.max_theta = options.max_theta;
  record.beyond_max_theta = problem.beyond_max_theta();
  record.floor = options.floor;
  if (!options.take_sigma()) record.below_floor = problem.below_floor();
}

std::string_view weights_name(const FitOptions& options) {
  if (options.noise) return "noise";
  switch (options.weights) {
    case FitWeights::aoi:
      return "aoi";
    case FitWeights::uniform:
      return "uniform";
    default:
      return "sigma";
  }
}

void add_residuals(FitRecord& record, const FitProblem& problem, const FitSummary& summary) {
  const FitOptions& options = problem.options();
  record.residuals = residuals_name(problem);
  record.weights = weights_name(options);
  record.loss = options.loss == FitLoss::cauchy ? "cauchy" : "linear";
  if (options.noise) {
    record.noise_relative = rounded(problem.noise()->relative, 4);
    record.noise_floor = rounded(problem.noise()->floor, 4);
    if (!options.noise->relative) record.noise_estimated.push_back("relative");
    if (!options.noise->floor) record.noise_estimated.push_back("floor");
  }
  record.rms = optional_rounded(summary.log_rms.of_samples, 4);
  record.rms_by_incidence = optional_rounded(summary.log_rms.of_incidences, 4);
  if (summary.log_rms.samples < problem.samples()) record.rms_samples = summary.log_rms.samples;
  if (options.take_sigma()) {
    record.reduced_chi_square = rounded(summary.linear.reduced_chi_square, 3);
    record.degrees_of_freedom = summary.linear.degrees_of_freedom;
  }
  if (problem.bands().size() > 1) return;
  for (const IncidenceFit& at : summary.incidences) {
    if (!std::isfinite(at.dhr)) continue;
    record.incidences.push_back(
        {.theta_i = at.theta_i,
         .settings = at.first == at.last ? std::nullopt : std::optional(FitRange{at.first, at.last}),
         .samples = at.samples,
         .rms = rounded(at.rms, 3),
         .dhr = rounded(at.dhr, 3)});
  }
}

FitRecord fit_record(const FitProblem& problem, const FitSummary& summary, const MaterialHeading& heading) {
  FitRecord record{.command = heading.command, .data = heading.data, .channel = heading.channel};
  add_samples(record, problem);
  add_residuals(record, problem, summary);
  record.starts = summary.fit.starts;
  record.converged = summary.fit.converged;
  record.reached = summary.fit.reached;
  record.is_descending = !summary.fit.best.converged;
  record.condition = rounded(summary.linear.condition, 2);
  record.intervals = summary.profiled ? "profile" : "linear";
  record.level = level;
  if (std::string bad = verdict(problem, summary); !bad.empty()) record.warnings.push_back(std::move(bad));
  if (summary.low_readings) record.warnings.push_back(text_of(*summary.low_readings, problem.options()));
  add_parameters(record, problem, summary);
  return record;
}

}  // namespace

MaterialContent fitted_material(const FitProblem& problem, const FitSummary& summary,
                                const MaterialHeading& heading) {
  MaterialContent material{.name = heading.name,
                           .description = heading.description,
                           .source = heading.source,
                           .license = {},
                           .variant = problem.options().variant,
                           .bands = {},
                           .grid = {},
                           .fit = fit_record(problem, summary, heading)};
  for (std::size_t b = 0; b < summary.bands.size(); ++b) {
    Band band{problem.bands().size() > 1 ? problem.bands()[b].wavelength_nm : std::nullopt, summary.bands[b]};
    for (const ParameterRow& row : parameter_table)
      band.parameters.*row.member = rounded(band.parameters.*row.member, 8);
    material.bands.push_back(band);
  }
  return material;
}

}  // namespace brdftab

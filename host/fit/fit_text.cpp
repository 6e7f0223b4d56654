#include "host/fit/fit_text.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

// A factor below this is not worth a measurement.
constexpr double worthwhile_gain = 1.2;
// From this rms of ln(model/data) on a fit is bad; the second holds where a parameter ends where no surface
// lies. Nine public measurements of real surfaces end between 0.01 and 0.35.
constexpr double bad_rms = 0.5, bad_rms_at_bounds = 0.3;
// Noise alone does not bring a larger reduced chi-square than this.
constexpr double chi_square_of_noise = 4;
constexpr std::array<std::string_view, 3> telling_bounds{"n_eff", "w", "delta"};

std::string flags(const FittedVariable& variable) {
  std::vector<std::string_view> words;
  if (variable.at_bound) words.push_back("at bound");
  if (variable.unidentifiable())
    words.push_back("unidentifiable");
  else if (variable.lacks_lower_limit())
    words.push_back("no lower limit");
  else if (variable.lacks_upper_limit())
    words.push_back("no upper limit");
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string range(double low, double high) { return fmt::format("{:.4g} to {:.4g}", low, high); }

std::string interval_text(const FittedVariable& variable) {
  return variable.has_interval ? range(variable.interval.low, variable.interval.high) : "-";
}

std::string data_range(const FitProblem& problem) {
  const auto [theta_i, theta_s, brdf] = problem.sample_ranges();
  return fmt::format(
      "{} samples, theta_i {} to {} degrees, theta_s {} to {} degrees, f {:.4g} to {:.4g} 1/sr",
      problem.samples(), shortest(theta_i.low), shortest(theta_i.high), shortest(theta_s.low),
      shortest(theta_s.high), brdf.low, brdf.high);
}

std::string search_line(const FitSummary& summary) {
  const Fit& fit = summary.fit;
  return fmt::format("{} starts, {} converged, {} of them within 1 % of the best rms{}", fit.starts,
                     fit.converged, fit.reached,
                     fit.best.converged ? "" : "; the best was still descending along a flat valley");
}

std::string rms_text(const FitProblem& problem, const FitSummary& summary) {
  std::string of_some;
  if (summary.log_rms.samples < problem.samples())
    of_some = fmt::format(" over the {} of {} samples above {} 1/sr", summary.log_rms.samples,
                          problem.samples(), shortest(problem.options().floor));
  if (summary.log_rms.samples == 0) return fmt::format("rms of ln(model/data){}: none", of_some);
  return fmt::format("rms of ln(model/data){}, all samples alike: {:.4g}, each incidence alike: {:.4g}",
                     of_some, summary.log_rms.of_samples, summary.log_rms.of_incidences);
}

std::string left_out_text(const FitProblem& problem) {
  std::string text = fmt::format("left out: {} samples beyond {} degrees", problem.beyond_max_theta(),
                                 shortest(problem.options().max_theta));
  if (problem.options().take_sigma())
    return text + "; none for its value, zero and negative readings are kept";
  return text + fmt::format(", {} below {} 1/sr", problem.below_floor(), shortest(problem.options().floor));
}

// What the residuals are and, in units of sigma, how well they agree with it.
std::string residuals_text(const FitProblem& problem, const FitSummary& summary) {
  const FitOptions& options = problem.options();
  std::string text = fmt::format("residuals: {}", residuals_name(problem));
  if (!options.take_sigma())
    return text + (options.weights == FitWeights::aoi ? ", each incidence alike" : ", all samples alike");
  text += options.noise ? ", " + noise_text(*problem.noise(), *options.noise) : ", sigma given with the data";
  const double reduced = summary.linear.reduced_chi_square;
  return text +
         fmt::format(
             "; reduced chi-square {:.3g} of {} samples, {} degrees of freedom: standard errors are {}",
             reduced, problem.samples(), summary.linear.degrees_of_freedom,
             reduced > 1 ? "scaled by its root" : "those of sigma");
}

std::string incidence_text(const IncidenceFit& at, std::string_view to) {
  return at.first == at.last ? shortest(at.theta_i)
                             : fmt::format("{}{}{}", shortest(at.first), to, shortest(at.last));
}

std::string parameters_text(const FitProblem& problem, const FitSummary& summary) {
  std::string text;
  text += fmt::format("{:<20} {:>12} {:>12}   {:<26} {}\n", "parameter", "value", "std. error",
                      summary.profiled ? "95 % interval (profile)" : "95 % interval (linear)", "");
  for (const FittedVariable& variable : summary.variables)
    text += fmt::format(
        "{:<20} {:>12.5g} {:>12}   {:<26} {}\n", variable.name, variable.value,
        std::isnan(variable.standard_error) ? "-" : fmt::format("{:.2g}", variable.standard_error),
        interval_text(variable), flags(variable));
  for (std::size_t p = 0; p < parameter_table.size(); ++p)
    if (problem.options().choices[p].fixed)
      text += fmt::format("{:<20} {:>12.5g} {:>12}   {:<26} fixed\n", parameter_table[p].name,
                          *problem.options().choices[p].fixed, "-", "");
  return text;
}

std::string incidences_text(const FitProblem& problem, const FitSummary& summary) {
  std::string text;
  if (problem.options().take_sigma())
    text += fmt::format("rms of {} by incidence\n", residuals_name(problem));
  const bool together = std::any_of(summary.incidences.begin(), summary.incidences.end(),
                                    [](const IncidenceFit& at) { return at.first != at.last; });
  if (together)
    text += fmt::format("  {} angles of incidence, neighbouring ones in one line; DHR at their mean\n",
                        problem.incidences().size());
  for (const IncidenceFit& at : summary.incidences)
    text += fmt::format("  {}theta_i = {:<{}} {:.4g}   ({} samples)   DHR {:.4g}\n",
                        problem.bands().size() > 1 ? at.channel + " " : "", incidence_text(at, " to "),
                        together ? 16 : 8, at.rms, at.samples, at.dhr);
  return text;
}

std::string sufficiency_text(const FitSummary& summary) {
  std::string text;
  if (!summary.sufficiency.empty()) text += "poorly known, and what would tell\n";
  for (const Sufficiency& entry : summary.sufficiency) {
    const std::string& name = summary.variables[entry.variable].name;
    text +=
        fmt::format("  {} is seen by theta_i = {} to {} degrees (9/10 of what the data say of it alone); ",
                    name, shortest(entry.seen_from), shortest(entry.seen_to));
    if (entry.gain < worthwhile_gain)
      text += "no in-plane scan would tell it much better\n";
    else
      text += fmt::format("an in-plane scan at theta_i = {} would narrow its standard error {:.2g} times\n",
                          shortest(entry.helpful_theta_i), entry.gain);
  }
  return text;
}

}  // namespace

std::string_view residuals_name(const FitProblem& problem) {
  return problem.options().take_sigma() ? "(model - data)/sigma" : "ln(model/data)";
}

std::string verdict(const FitProblem& problem, const FitSummary& summary) {
  const double rms = std::max(summary.log_rms.of_samples, summary.log_rms.of_incidences);
  if (problem.options().take_sigma() && summary.linear.reduced_chi_square <= chi_square_of_noise) return {};
  std::vector<std::string> at_bounds;
  for (const FittedVariable& variable : summary.variables)
    for (const std::string_view name : telling_bounds)
      if (variable.at_bound && variable.name.substr(0, variable.name.find('[')) == name)
        at_bounds.push_back(fmt::format("{} = {:.4g}", variable.name, variable.value));
  if (!(rms > bad_rms) && !(rms > bad_rms_at_bounds && !at_bounds.empty())) return {};
  return fmt::format(
      "bad fit, not to be used as it is: model and data differ by a factor of {:.2g} (rms of ln(model/data) "
      "{:.2g}), where real surfaces are met within 1.01 to 1.4{}; look at the file's units (`scale`), "
      "azimuths (`flip_azimuth`), light (`polarization`) and outliers (`loss` cauchy), and try more `starts`",
      std::exp(rms), rms,
      at_bounds.empty() ? ""
                        : fmt::format(", and {} {} at the end of what is allowed", fmt::join(at_bounds, ", "),
                                      at_bounds.size() > 1 ? "are" : "is"));
}

std::string summary_text(const FitProblem& problem, const FitSummary& summary) {
  std::string text;
  if (const std::string bad = verdict(problem, summary); !bad.empty()) text += bad + "\n";
  text += fmt::format("{}\n", data_range(problem));
  text += left_out_text(problem) + "\n";
  text += residuals_text(problem, summary) + "\n";
  text += fmt::format("{}\n\n", search_line(summary));
  text += parameters_text(problem, summary);
  text += fmt::format("\n{}\n", rms_text(problem, summary));
  text += incidences_text(problem, summary);
  text +=
      fmt::format("condition number of J^T J, columns of unit length: {:.2g}\n", summary.linear.condition);
  if (!summary.correlations.empty()) text += "strongest correlations\n";
  for (const Correlation& pair : summary.correlations)
    text += fmt::format("  {:<20} {:<20} {:+.4f}\n", pair.first, pair.second, pair.value);
  return text + sufficiency_text(summary);
}

}  // namespace brdftab

// A fit in words: the table for standard output and the material file.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "host/base/numbers.hpp"
#include "host/fit/fit_summary.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/model/variant.hpp"

namespace brdftab {
namespace {

// A factor below this is not worth a measurement.
constexpr double worthwhile_gain = 1.2;
// Rms of ln(model/data) from which on a fit is bad, and where parameters besides end where no surface lies.
// Nine public measurements of real surfaces end between 0.01 and 0.35.
constexpr double bad_rms = 0.5, bad_rms_at_bounds = 0.3;
// Noise alone brings no larger reduced chi-square.
constexpr double chi_square_of_noise = 4;
constexpr std::array<std::string_view, 3> telling_bounds{"n_eff", "w", "delta"};

std::string flags(const FittedVariable& variable) {
  std::vector<std::string_view> words;
  if (variable.at_bound) words.push_back("at bound");
  if (variable.unidentifiable())
    words.push_back("unidentifiable");
  else if (variable.interval.open_below && !variable.at_bound)
    words.push_back("no lower limit");
  else if (variable.interval.open_above && !variable.at_bound)
    words.push_back("no upper limit");
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string range(double low, double high) { return fmt::format("{:.4g} to {:.4g}", low, high); }

std::string interval_text(const FittedVariable& variable) {
  return variable.has_interval ? range(variable.interval.low, variable.interval.high) : "-";
}

std::string data_range(const FitProblem& problem) {
  double low_i = 90, high_i = 0, low_s = 90, high_s = 0, low_f = HUGE_VAL, high_f = 0;
  for (const FitBand& band : problem.bands())
    for (const auto& sample : band.samples) {
      low_i = std::min(low_i, sample.pair.theta_i);
      high_i = std::max(high_i, sample.pair.theta_i);
      low_s = std::min(low_s, sample.pair.model_theta_s());
      high_s = std::max(high_s, sample.pair.model_theta_s());
      low_f = std::min(low_f, sample.brdf);
      high_f = std::max(high_f, sample.brdf);
    }
  return fmt::format(
      "{} samples, theta_i {} to {} degrees, theta_s {} to {} degrees, f {:.4g} to {:.4g} 1/sr",
      problem.samples(), shortest(low_i), shortest(high_i), shortest(low_s), shortest(high_s), low_f, high_f);
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

std::string_view misfit_name(const FitProblem& problem) {
  return problem.options().take_sigma() ? "(model - data)/sigma" : "ln(model/data)";
}

// What the residuals are and, in units of sigma, how well they agree with it.
std::string residuals_text(const FitProblem& problem, const FitSummary& summary) {
  const FitOptions& options = problem.options();
  std::string text = fmt::format("residuals: {}", misfit_name(problem));
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

std::string_view light_words(const FitProblem& problem) {
  if (!problem.is_of_one_light()) return "s- and p-polarised, fitted together; DHR of unpolarised";
  return light_word(problem.share_s());
}

std::string incidence_text(const IncidenceFit& at, std::string_view to) {
  return at.first == at.last ? shortest(at.theta_i)
                             : fmt::format("{}{}{}", shortest(at.first), to, shortest(at.last));
}

// TOML takes digits after a point, and no point alone.
std::string toml_float(double value) {
  const std::string text = shortest(value);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// A TOML basic string.
std::string toml_string(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? ' ' : c;
  }
  return result + '"';
}

std::string parameter_line(const FitSummary& summary, const FitProblem& problem, std::size_t band,
                           std::size_t parameter) {
  const ParameterRow& row = parameter_table[parameter];
  std::string line = fmt::format("{} = {:.8g}", row.name, summary.bands[band].*row.member);
  for (std::size_t v = 0; v < summary.variables.size(); ++v) {
    const FitVariable& variable = problem.variables()[v];
    if (variable.parameter != parameter ||
        std::find(variable.bands.begin(), variable.bands.end(), band) == variable.bands.end())
      continue;
    const FittedVariable& fitted = summary.variables[v];
    const std::string words = flags(fitted);
    return fmt::format("{:<28} # 95 %: {}; bounds {}{}{}", line, interval_text(fitted),
                       range(variable.minimum, variable.maximum), words.empty() ? "" : "; ", words);
  }
  return fmt::format("{:<28} # fixed", line);
}

}  // namespace

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
      "{:.2g}), where real surfaces are met within 1.01 to 1.4{}; look at the file's units (--scale), "
      "azimuths (--flip-azimuth), light (--polarization) and outliers (--loss cauchy), and try more --starts",
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
  text += fmt::format("\n{}\n", rms_text(problem, summary));
  if (problem.options().take_sigma()) text += fmt::format("rms of {} by incidence\n", misfit_name(problem));
  const bool together = std::any_of(summary.incidences.begin(), summary.incidences.end(),
                                    [](const IncidenceFit& at) { return at.first != at.last; });
  if (together)
    text += fmt::format("  {} angles of incidence, neighbouring ones in one line; DHR at their mean\n",
                        problem.incidences().size());
  for (const IncidenceFit& at : summary.incidences)
    text += fmt::format("  {}theta_i = {:<{}} {:.4g}   ({} samples)   DHR {:.4g}\n",
                        problem.bands().size() > 1 ? at.channel + " " : "", incidence_text(at, " to "),
                        together ? 16 : 8, at.rms, at.samples, at.dhr);
  text +=
      fmt::format("condition number of J^T J, columns of unit length: {:.2g}\n", summary.linear.condition);
  if (!summary.correlations.empty()) text += "strongest correlations\n";
  for (const Correlation& pair : summary.correlations)
    text += fmt::format("  {:<20} {:<20} {:+.4f}\n", pair.first, pair.second, pair.value);
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

std::string material_text(const FitProblem& problem, const FitSummary& summary,
                          const MaterialHeading& heading) {
  const FitOptions& options = problem.options();
  std::string text;
  if (const std::string bad = verdict(problem, summary); !bad.empty()) text += fmt::format("# {}\n", bad);
  text += fmt::format("name = {}\n", toml_string(heading.name));
  if (!heading.description.empty())
    text += fmt::format("description = {}\n", toml_string(heading.description));
  text += fmt::format("source = {}\n\n", toml_string(heading.source));
  text += fmt::format("# {}\n", heading.command);
  text += fmt::format("# {}\n# {}\n", rms_text(problem, summary), residuals_text(problem, summary));
  text += fmt::format("# {}\n", data_range(problem));
  text += fmt::format("# {}\n", search_line(summary));
  text += fmt::format("# condition number of J^T J {:.2g}; intervals by {}\n", summary.linear.condition,
                      summary.profiled ? "profile likelihood" : "standard errors");
  text += fmt::format("# light: {}; {}\n", light_words(problem), left_out_text(problem));
  if (summary.low_readings) text += fmt::format("# warning: {}\n", text_of(*summary.low_readings, options));
  if (problem.bands().size() == 1) {
    text += options.take_sigma() ? fmt::format("# rms of {} by theta_i:", misfit_name(problem))
                                 : "# rms by theta_i:";
    for (const IncidenceFit& at : summary.incidences)
      text += fmt::format(" {}: {:.3g}", incidence_text(at, "-"), at.rms);
    text += "\n# DHR by theta_i:";
    for (const IncidenceFit& at : summary.incidences)
      text += fmt::format(" {}: {:.3g}", shortest(at.theta_i), at.dhr);
    text += "\n";
  }
  text += "\n[parameters]\n";
  for (std::size_t p = 0; p < parameter_table.size(); ++p)
    text += parameter_line(summary, problem, 0, p) + "\n";
  std::string model;
  for (const VariantRow& row : variant_table()) {
    const auto choice = choice_name(row, options.variant);
    if (choice != row.choices.front())
      model +=
          fmt::format("{} = {}\n", row.name, row.is_boolean() ? std::string(choice) : toml_string(choice));
  }
  if (!model.empty()) text += "\n[model]\n" + model;
  if (problem.bands().size() > 1)
    for (std::size_t b = 0; b < problem.bands().size(); ++b) {
      text += fmt::format("\n[[band]]\nwavelength_nm = {}\n", toml_float(*problem.bands()[b].wavelength_nm));
      for (std::size_t p = 0; p < parameter_table.size(); ++p)
        for (const FitVariable& variable : problem.variables())
          if (variable.parameter == p && variable.bands.size() == 1 && variable.bands.front() == b)
            text += parameter_line(summary, problem, b, p) + "\n";
    }
  return text;
}

}  // namespace brdftab

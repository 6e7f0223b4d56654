// A fit in words: the table for standard output and the material file.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/fit_summary.hpp"
#include "host/numbers.hpp"
#include "host/switches.hpp"

namespace brdftab {
namespace {

// A factor below this is not worth a measurement.
constexpr double worthwhile_gain = 1.2;

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
  return fmt::format("{} samples, theta_i {} to {} degrees, theta_s {} to {} degrees, f {:.4g} to {:.4g} 1/sr", problem.samples(),
                     shortest(low_i), shortest(high_i), shortest(low_s), shortest(high_s), low_f, high_f);
}

std::string search_line(const FitSummary& summary) {
  const Fit& fit = summary.fit;
  return fmt::format("{} starts, {} converged, {} of them within 1 % of the best rms{}", fit.starts, fit.converged, fit.reached,
                     fit.best.converged ? "" : "; the best was still descending along a flat valley");
}

std::string rms_text(const FitSummary& summary) {
  return fmt::format("all samples alike: {:.4g}, each incidence alike: {:.4g}", summary.rms_of_samples,
                     summary.rms_of_incidences);
}

std::string incidence_text(const IncidenceFit& at, std::string_view to) {
  return at.first == at.last ? shortest(at.theta_i) : fmt::format("{}{}{}", shortest(at.first), to, shortest(at.last));
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

std::string parameter_line(const FitSummary& summary, const FitProblem& problem, std::size_t band, std::size_t parameter) {
  const ParameterRow& row = parameter_table[parameter];
  std::string line = fmt::format("{} = {:.8g}", row.name, summary.bands[band].*row.member);
  for (std::size_t v = 0; v < summary.variables.size(); ++v) {
    const FitVariable& variable = problem.variables()[v];
    if (variable.parameter != parameter || std::find(variable.bands.begin(), variable.bands.end(), band) == variable.bands.end())
      continue;
    const FittedVariable& fitted = summary.variables[v];
    const std::string words = flags(fitted);
    return fmt::format("{:<28} # 95 %: {}; bounds {}{}{}", line, interval_text(fitted), range(variable.minimum, variable.maximum),
                       words.empty() ? "" : "; ", words);
  }
  return fmt::format("{:<28} # fixed", line);
}

}  // namespace

std::string summary_text(const FitProblem& problem, const FitSummary& summary) {
  std::string text = fmt::format("{}\n", data_range(problem));
  text += fmt::format("left out: {} samples beyond {} degrees, {} below {} 1/sr\n", problem.beyond_max_theta(),
                      shortest(problem.options().max_theta), problem.below_floor(), shortest(problem.options().floor));
  text += fmt::format("{}\n\n", search_line(summary));
  text += fmt::format("{:<20} {:>12} {:>12}   {:<26} {}\n", "parameter", "value", "std. error",
                      summary.profiled ? "95 % interval (profile)" : "95 % interval (linear)", "");
  for (const FittedVariable& variable : summary.variables)
    text += fmt::format("{:<20} {:>12.5g} {:>12}   {:<26} {}\n", variable.name, variable.value,
                        std::isnan(variable.standard_error) ? "-" : fmt::format("{:.2g}", variable.standard_error),
                        interval_text(variable), flags(variable));
  for (std::size_t p = 0; p < parameter_table.size(); ++p)
    if (problem.options().choices[p].fixed)
      text += fmt::format("{:<20} {:>12.5g} {:>12}   {:<26} fixed\n", parameter_table[p].name,
                          *problem.options().choices[p].fixed, "-", "");
  text += fmt::format("\nrms of ln(model/data), {}\n", rms_text(summary));
  const bool together = std::any_of(summary.incidences.begin(), summary.incidences.end(),
                                    [](const IncidenceFit& at) { return at.first != at.last; });
  if (together)
    text +=
        fmt::format("  {} angles of incidence, neighbouring ones in one line; DHR at their mean\n", problem.incidences().size());
  for (const IncidenceFit& at : summary.incidences)
    text += fmt::format("  {}theta_i = {:<{}} {:.4g}   ({} samples)   DHR {:.4g}\n",
                        problem.bands().size() > 1 ? at.channel + " " : "", incidence_text(at, " to "), together ? 16 : 8, at.rms,
                        at.samples, at.dhr);
  text += fmt::format("condition number of J^T J, columns of unit length: {:.2g}\n", summary.linear.condition);
  if (!summary.correlations.empty()) text += "strongest correlations\n";
  for (const Correlation& pair : summary.correlations)
    text += fmt::format("  {:<20} {:<20} {:+.4f}\n", pair.first, pair.second, pair.value);
  if (!summary.sufficiency.empty()) text += "poorly known, and what would tell\n";
  for (const Sufficiency& entry : summary.sufficiency) {
    const std::string& name = summary.variables[entry.variable].name;
    text += fmt::format("  {} is seen by theta_i = {} to {} degrees (9/10 of what the data say of it alone); ", name,
                        shortest(entry.seen_from), shortest(entry.seen_to));
    if (entry.gain < worthwhile_gain)
      text += "no in-plane scan would tell it much better\n";
    else
      text += fmt::format("an in-plane scan at theta_i = {} would narrow its standard error {:.2g} times\n",
                          shortest(entry.helpful_theta_i), entry.gain);
  }
  return text;
}

std::string material_text(const FitProblem& problem, const FitSummary& summary, const MaterialHeading& heading) {
  const FitOptions& options = problem.options();
  std::string text = fmt::format("name = {}\n", toml_string(heading.name));
  if (!heading.description.empty()) text += fmt::format("description = {}\n", toml_string(heading.description));
  text += fmt::format("source = {}\n\n", toml_string(heading.source));
  text += fmt::format("# {}\n", heading.command);
  text += fmt::format("# rms of ln(model/data), {}\n", rms_text(summary));
  text += fmt::format("# {}\n", data_range(problem));
  text += fmt::format("# {}\n", search_line(summary));
  text += fmt::format("# condition number of J^T J {:.2g}; intervals by {}\n", summary.linear.condition,
                      summary.profiled ? "profile likelihood" : "standard errors");
  text += fmt::format("# light: {}; left out: {} samples beyond {} degrees, {} below {} 1/sr\n",
                      options.share_s == 1   ? "s-polarised"
                      : options.share_s == 0 ? "p-polarised"
                                             : "unpolarised",
                      problem.beyond_max_theta(), shortest(options.max_theta), problem.below_floor(), shortest(options.floor));
  if (problem.bands().size() == 1) {
    text += "# rms by theta_i:";
    for (const IncidenceFit& at : summary.incidences) text += fmt::format(" {}: {:.3g}", incidence_text(at, "-"), at.rms);
    text += "\n# DHR by theta_i:";
    for (const IncidenceFit& at : summary.incidences) text += fmt::format(" {}: {:.3g}", shortest(at.theta_i), at.dhr);
    text += "\n";
  }
  text += "\n[parameters]\n";
  for (std::size_t p = 0; p < parameter_table.size(); ++p) text += parameter_line(summary, problem, 0, p) + "\n";
  std::string model;
  for (const SwitchRow& row : switch_table()) {
    const auto choice = choice_name(row, options.switches);
    if (choice != row.choices.front())
      model += fmt::format("{} = {}\n", row.name, row.is_boolean() ? std::string(choice) : toml_string(choice));
  }
  if (!model.empty()) text += "\n[model]\n" + model;
  if (problem.bands().size() > 1)
    for (std::size_t b = 0; b < problem.bands().size(); ++b) {
      text += fmt::format("\n[[band]]\nwavelength_nm = {:#}\n", *problem.bands()[b].wavelength_nm);
      for (std::size_t p = 0; p < parameter_table.size(); ++p)
        for (const FitVariable& variable : problem.variables())
          if (variable.parameter == p && variable.bands.size() == 1 && variable.bands.front() == b)
            text += parameter_line(summary, problem, b, p) + "\n";
    }
  return text;
}

}  // namespace brdftab

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <map>

#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/commands/command.hpp"
#include "host/commands/options/measurement_option.hpp"
#include "host/fit/fit_text.hpp"
#include "host/fit/fitted_material.hpp"
#include "host/formats/read_measurement.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/model/variant.hpp"
#include "host/pictures/fit_pictures.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string data;
  std::string output;
  std::string channel;
  std::string wavelengths;
  std::string polarization = "unpolarized";
  std::string weights;
  std::string noise;
  std::string loss = "linear";
  std::string share = "geometry";
  std::string intervals;
  std::string name;
  std::string description;
  std::string source;
  std::string report;
  std::vector<std::string> fixed;
  std::vector<std::string> bounds;
  std::vector<std::string> model;
  std::optional<std::string> device;
  MeasurementOption reading;
  std::size_t merl_samples = 800;
  std::uint64_t merl_seed = 1;
  FitOptions fit;
  std::optional<double> floor;
  bool force = false;
};

void choose_variant(Variant& variant, const std::string& text) {
  const auto equals = std::min(text.find('='), text.size());
  for (const VariantRow& row : variant_table()) {
    if (row.name != text.substr(0, equals)) continue;
    const std::string value = text.substr(std::min(equals + 1, text.size()));
    const auto choice = std::find(row.choices.begin(), row.choices.end(), value);
    if (choice == row.choices.end())
      throw BadInput("--model {}: must be one of {}", excerpt(text), fmt::join(row.choices, ", "));
    row.set(variant, static_cast<int>(choice - row.choices.begin()));
    return;
  }
  throw BadInput("--model {}: must be SWITCH=CHOICE, with a switch that `brdftab parameters` lists",
                 excerpt(text));
}

std::size_t channel_index(const Measurement& measurement, const std::string& name) {
  if (const auto index = measurement.find_channel(name)) return *index;
  throw BadInput("--channel {}: {} has {}", excerpt(name), measurement.source,
                 fmt::join(measurement.channels, ", "));
}

// Bands of a material increase in wavelength.
Measurement by_wavelength(const Measurement& measurement) {
  std::map<double, std::size_t> order;
  for (std::size_t c = 0; c < measurement.channels.size(); ++c)
    if (!order.emplace(*measurement.wavelength_nm(c), c).second)
      throw BadInput("{}: two channels are {} nm", measurement.source,
                     shortest(*measurement.wavelength_nm(c)));
  Measurement sorted{.source = measurement.source,
                     .channels = {},
                     .samples = {},
                     .warnings = {},
                     .incidence_width = measurement.incidence_width,
                     .mean_of_exchanges = measurement.mean_of_exchanges};
  for (const auto& [wavelength, c] : order) {
    for (MeasuredSample sample : measurement.channel(c).samples) {
      sample.channel = sorted.channels.size();
      sorted.samples.push_back(sample);
    }
    sorted.channels.push_back(measurement.channels[c]);
  }
  return sorted;
}

Measurement chosen_channels(const Options& options, const Measurement& measurement) {
  if (!options.wavelengths.empty()) {
    for (std::size_t c = 0; c < measurement.channels.size(); ++c)
      if (!measurement.wavelength_nm(c))
        throw BadInput("--wavelengths all: the channel '{}' of {} is no wavelength in nm",
                       excerpt(measurement.channels[c]), measurement.source);
    // A material with such bands is a wrong number that outlives its warning.
    for (std::size_t c = 0; c < measurement.channels.size(); ++c)
      if (const double nm = *measurement.wavelength_nm(c);
          !options.reading.options().wavelength_unit && !is_plausible_wavelength(nm))
        throw BadInput(
            "--wavelengths all: the channel '{}' of {} would be {} nm; --wavelength-unit nm, um or m says "
            "its unit",
            excerpt(measurement.channels[c]), measurement.source, shortest(nm));
    return by_wavelength(measurement);
  }
  if (!options.channel.empty()) return measurement.channel(channel_index(measurement, options.channel));
  if (measurement.channels.size() > 1)
    throw BadInput("{}: has {} channels: --channel takes one of {}{}", measurement.source,
                   measurement.channels.size(),
                   excerpt(fmt::format("{}", fmt::join(measurement.channels, ", ")), 200),
                   measurement.wavelength_nm(0) ? "; --wavelengths all fits them together" : "");
  return measurement;
}

// Says where the numbers come from: what the user gives, and the file.
MaterialHeading heading(const Options& options, const CommonOptions& common) {
  const std::filesystem::path path(options.data);
  const std::string file = path.filename().string();
  const std::string measurement =
      options.channel.empty() ? file : fmt::format("{}, channel {}", file, options.channel);
  return {.name = options.name.empty() ? path.stem().string() : options.name,
          .description = options.description,
          .source = options.source.empty() ? measurement : fmt::format("{}; {}", options.source, measurement),
          .command = common.command_line,
          .data = file,
          .channel = options.channel};
}

// What would contradict itself is refused, not guessed.
void check_statistics(const Options& options, const FitOptions& fit) {
  if (fit.noise && !options.weights.empty())
    throw BadInput(
        "--weights {}: --noise gives each sample its sigma, and with it its weight: give one of the two",
        options.weights);
  if (options.floor && fit.take_sigma())
    throw BadInput(
        "--floor {}: --weights sigma and --noise take every reading: to leave out those that are measured "
        "low makes the fitted f too high; leave --floor out, or --weights sigma and --noise",
        shortest(*options.floor));
  if (fit.noise && !fit.noise->is_given() && fit.loss == FitLoss::cauchy)
    throw BadInput(
        "--noise {}: an estimate would follow the outliers: --loss cauchy takes a noise that is given, as "
        "--noise 2%,1e-3",
        options.noise);
}

FitOptions fit_options(const Options& options) {
  FitOptions fit = options.fit;
  for (const auto& text : options.fixed) fix_parameter(fit.choices, text);
  for (const auto& text : options.bounds) bound_parameter(fit.choices, text);
  for (const auto& text : options.model) choose_variant(fit.variant, text);
  if (!options.noise.empty()) fit.noise = noise_choice(options.noise);
  fit.weights = options.weights == "sigma"     ? FitWeights::sigma
                : options.weights == "uniform" ? FitWeights::uniform
                                               : FitWeights::aoi;
  fit.loss = options.loss == "cauchy" ? FitLoss::cauchy : FitLoss::linear;
  fit.share_geometry = options.share == "geometry";
  check_statistics(options, fit);
  if (options.floor) fit.floor = *options.floor;
  return fit;
}

Measurement read(const Options& options, const CommonOptions& common) {
  MeasurementOptions reading = options.reading.options();
  reading.merl_samples = options.merl_samples;
  reading.merl_seed = options.merl_seed;
  reading.light = light_named(options.polarization);
  const Measurement whole = read_measurement(options.data, reading);
  for (const auto& note : whole.notes) say(common, fmt::format("{}: {}", whole.source, note));
  for (const auto& warning : whole.warnings)
    say(common, fmt::format("warning: {}: {}", whole.source, warning));
  return chosen_channels(options, whole);
}

// The verdict stands in the file's first line, where nobody overlooks it.
std::string file_text(const FitProblem& problem, const FitSummary& summary, const MaterialHeading& heading) {
  const Material material = Material::of(fitted_material(problem, summary, heading));
  const std::string bad = verdict(problem, summary);
  return bad.empty() ? material.text() : fmt::format("# {}\n{}", spelled(bad), material.text());
}

void say_warnings(const CommonOptions& common, const Measurement& measurement, const FitProblem& problem,
                  const FitSummary& summary) {
  if (summary.low_readings)
    say(common, fmt::format("warning: {}: {}", measurement.source,
                            text_of(*summary.low_readings, problem.options())));
  const auto brightest = std::max_element(summary.incidences.begin(), summary.incidences.end(),
                                          [](const auto& a, const auto& b) { return a.dhr < b.dhr; });
  if (brightest->dhr > 1)
    say(common, fmt::format("warning: the fitted material's DHR reaches {:.4g} at theta_i = {} degrees: the "
                            "model does not bound it",
                            brightest->dhr, shortest(brightest->theta_i)));
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  silence_solver();
  const FitOptions fitting = fit_options(options);
  PartialFile file(options.output, options.force);
  const Measurement measurement = read(options, common);
  const Device device = select_device(options.device);
  const Engine engine(device, Precision::float64, Precision::float32, common.watch);
  const auto start = std::chrono::steady_clock::now();
  FitProblem problem(engine, measurement, fitting);
  if (problem.incidences().size() == 1)
    say(common, fmt::format("warning: {}: one incidence only: what depends on theta_i stays open",
                            measurement.source));
  const bool profile =
      options.intervals.empty() ? problem.bands().size() == 1 : options.intervals == "profile";
  const Fit found = fit(problem);
  const FitSummary summary = summarize(engine, problem, found, profile);
  write_whole(file, file_text(problem, summary, heading(options, common)));
  if (!options.report.empty()) write_fit_pictures(engine, problem, summary, options.report, options.force);
  const std::string text = spelled(summary_text(problem, summary));
  std::fwrite(text.data(), 1, text.size(), stdout);
  say_warnings(common, measurement, problem, summary);
  const double all = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  say(common, fmt::format("search {:.2f} s ({:.0f} % of it in kernels, the rest in the solver), {} "
                          "evaluations; with intervals {:.2f} s; on {}",
                          found.seconds, 100 * found.kernel_seconds / found.seconds, found.evaluations, all,
                          device.name));
  return ExitStatus::done;
}

// Lists what the material file says of the fit.
std::string file_help() {
  std::string text =
      "The material file says of the fit, as data that other programs read:\n"
      "  [parameters]     the fitted parameters; what a spectrum's bands do not share is in each [[band]]\n"
      "  [fit.NAME]       of a parameter: low and high, the ends of its 95 % interval; open = \"below\",\n"
      "                   \"above\" or \"both\" where the data do not limit it on that side;\n"
      "                   at_bound = true where it ended at a bound; bounds = [LOW, HIGH]\n"
      "  [band.fit.NAME]  the same of a parameter of one band\n"
      "  [fit]            how the fit was made and how well it agrees:\n";
  for (const FitKey& key : fit_keys()) text += fmt::format("    {:<18} {}\n", key.name, key.meaning);
  return text + "    incidences         at each theta_i, degrees: samples, rms of the residuals, DHR\n";
}

void add_data_options(CLI::App& parser, Options& options) {
  parser
      .add_option("DATA", options.data,
                  "Measurement: CSV with theta_i_deg, theta_s_deg, phi_deg or phi_s_deg, brdf_per_sr (or "
                  "brdf_s_per_sr and brdf_p_per_sr) and optionally channel, wavelength_nm or wavelength_um, "
                  "and sigma (or sigma_s and sigma_p); or ALTA text (.alta, .dat), ASTM text (.astm), Zemax "
                  "tabular BSDF (.bsdf), MERL (.binary)")
      ->required();
  parser.add_option("--channel", options.channel, "The channel to fit, where the measurement has several");
  parser
      .add_option("--wavelengths", options.wavelengths, "all: fit every channel to one material with bands")
      ->check(CLI::IsMember({"all"}));
  parser
      .add_option("--polarization", options.polarization,
                  "The light: unpolarized (default), s, p, or all: s and p fitted together, which tells "
                  "n_eff from k_eff best. Of CSV it takes the column brdf, brdf_s or brdf_p (or brdf_per_sr, "
                  "brdf_s_per_sr, brdf_p_per_sr); unpolarised f is the mean of s and p where only those are "
                  "there. Of other formats, it says what light all values were measured in")
      ->check(CLI::IsMember({"unpolarized", "s", "p", "all"}));
  parser
      .add_option("--max-theta", options.fit.max_theta,
                  "Leave out samples with theta_i or theta_s beyond it, degrees; default 80")
      ->check(CLI::Range(1., 90.));
  options.reading.add(parser);
  parser
      .add_option("--merl-samples", options.merl_samples,
                  "Directions over the hemisphere that are taken of a MERL file; default 800")
      ->check(CLI::Range(16, 100000));
  parser.add_option("--merl-seed", options.merl_seed, "Of the choice of those directions; default 1");
}

void add_model_options(CLI::App& parser, Options& options) {
  parser
      .add_option("--share", options.share,
                  "What the bands share: geometry (rho, w_a, w_b, gamma, delta, w, n), the default, or none")
      ->check(CLI::IsMember({"geometry", "none"}));
  parser.add_option("--fix", options.fixed, "Hold a parameter: k_eff=0. Repeatable; default: all are free")
      ->type_name("NAME=VALUE");
  parser
      .add_option("--bounds", options.bounds,
                  "Bound a parameter: rho_surface=0.01:2. Repeatable; default: the ranges that `brdftab "
                  "parameters` lists")
      ->type_name("NAME=LOW:HIGH");
  parser
      .add_option("--model", options.model,
                  "Variant of the model: reflectance_shadowing=surface. Repeatable; default: the paper's")
      ->type_name("SWITCH=CHOICE");
}

void add_statistics_options(CLI::App& parser, Options& options) {
  parser
      .add_option("--floor", options.floor,
                  "Leave out samples at or below it, 1/sr; default 0.002. Only for residuals ln(model/data), "
                  "which suit noise in proportion to f: where noise reaches the readings left out, f and DHR "
                  "come out too high")
      ->check(CLI::NonNegativeNumber);
  parser
      .add_option("--weights", options.weights,
                  "aoi: residuals ln(model/data), each angle of incidence alike (default); uniform: the "
                  "same, all samples alike; sigma: residuals (model - data)/sigma over all samples, zero and "
                  "negative ones too, with the column sigma; standard errors are those of sigma, times the "
                  "root of reduced chi-square where that is above 1")
      ->check(CLI::IsMember({"aoi", "uniform", "sigma"}));
  parser
      .add_option("--noise", options.noise,
                  "In place of a column sigma: sigma^2 = (RELATIVE f)^2 + FLOOR^2 with f of the model, as "
                  "2%,1e-3 (FLOOR in 1/sr), all samples kept; either part or both may be `estimated`, by "
                  "maximum likelihood. Default: none")
      ->type_name("RELATIVE,FLOOR");
  parser.add_option("--loss", options.loss, "linear (default) or cauchy, which outliers hardly move")
      ->check(CLI::IsMember({"linear", "cauchy"}));
  parser
      .add_option("--intervals", options.intervals,
                  "profile: by profile likelihood (default for one channel); linear: from standard errors "
                  "(default for spectra)")
      ->check(CLI::IsMember({"profile", "linear"}));
  parser.add_option("--starts", options.fit.starts, "Starting points; default 48")
      ->check(CLI::Range(1, 10000));
  parser.add_option("--seed", options.fit.seed, "Of the starting points; default 1");
}

void add_output_options(CLI::App& parser, Options& options) {
  parser.add_option("-o,--output", options.output, "Material file to write (TOML)")->required();
  parser.add_option("--report", options.report,
                    "Folder for pictures (SVG): fit, residuals, V_m, correlations; default: none");
  parser.add_option("--name", options.name, "Of the material; default: the file's");
  parser.add_option("--description", options.description, "Of the material, for its file");
  parser.add_option("--source", options.source, "Of the measurement, for the material file");
  parser.add_flag("--force", options.force, "Overwrite an existing material file");
  add_device_option(parser, options.device);
}

}  // namespace

std::function<ExitStatus()> fit_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  add_data_options(parser, *options);
  add_model_options(parser, *options);
  add_statistics_options(parser, *options);
  add_output_options(parser, *options);
  parser.footer(file_help());
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

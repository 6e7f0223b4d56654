#include "host/fit.hpp"

#include <algorithm>

#include "host/commands/command.hpp"
#include "host/numbers.hpp"
#include "host/switches.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string data;
  std::string output;
  std::string channel;
  std::string wavelengths;
  std::string polarization = "unpolarized";
  std::string weights = "aoi";
  std::string loss = "linear";
  std::string share = "geometry";
  std::vector<std::string> fixed;
  std::vector<std::string> bounds;
  std::vector<std::string> model;
  std::optional<std::string> device;
  MeasurementOptions measurement;
  FitOptions fit;
  bool force = false;
};

void choose_variant(ModelSwitches& switches, const std::string& text) {
  const auto equals = std::min(text.find('='), text.size());
  for (const SwitchRow& row : switch_table()) {
    if (row.name != text.substr(0, equals)) continue;
    const std::string value = text.substr(std::min(equals + 1, text.size()));
    const auto choice = std::find(row.choices.begin(), row.choices.end(), value);
    if (choice == row.choices.end()) throw BadInput("--model {}: must be one of {}", excerpt(text), fmt::join(row.choices, ", "));
    row.set(switches, static_cast<int>(choice - row.choices.begin()));
    return;
  }
  throw BadInput("--model {}: must be SWITCH=CHOICE, with a switch that `brdftab parameters` lists", excerpt(text));
}

std::size_t channel_index(const Measurement& measurement, const std::string& name) {
  for (std::size_t c = 0; c < measurement.channels.size(); ++c)
    if (measurement.channels[c] == name ||
        (measurement.wavelength_nm(c) && parse_number(name) && *measurement.wavelength_nm(c) == *parse_number(name)))
      return c;
  throw BadInput("--channel {}: {} has {}", excerpt(name), measurement.source, fmt::join(measurement.channels, ", "));
}

Measurement chosen_channels(const Options& options, const Measurement& measurement) {
  if (!options.wavelengths.empty()) {
    for (std::size_t c = 0; c < measurement.channels.size(); ++c)
      if (!measurement.wavelength_nm(c))
        throw BadInput("--wavelengths all: the channel '{}' of {} is no wavelength in nm", excerpt(measurement.channels[c]),
                       measurement.source);
    return measurement;
  }
  if (!options.channel.empty()) return measurement.channel(channel_index(measurement, options.channel));
  if (measurement.channels.size() > 1)
    throw BadInput("{}: has {} channels: --channel takes one of {}{}", measurement.source, measurement.channels.size(),
                   excerpt(fmt::format("{}", fmt::join(measurement.channels, ", ")), 200),
                   measurement.wavelength_nm(0) ? "; --wavelengths all fits them together" : "");
  return measurement;
}

ExitStatus run(const Options& given, const CommonOptions& common) {
  Options options = given;
  for (const auto& text : options.fixed) fix_parameter(options.fit.choices, text);
  for (const auto& text : options.bounds) bound_parameter(options.fit.choices, text);
  for (const auto& text : options.model) choose_variant(options.fit.switches, text);
  options.fit.share_s = options.polarization == "s" ? 1 : options.polarization == "p" ? 0 : 0.5;
  options.fit.weights = options.weights == "sigma"     ? FitWeights::sigma
                        : options.weights == "uniform" ? FitWeights::uniform
                                                       : FitWeights::aoi;
  options.fit.loss = options.loss == "cauchy" ? FitLoss::cauchy : FitLoss::linear;
  options.fit.share_geometry = options.share == "geometry";
  const Measurement whole = read_measurement(options.data, options.measurement);
  for (const auto& warning : whole.warnings) say(common, fmt::format("warning: {}: {}", whole.source, warning));
  const Measurement measurement = chosen_channels(options, whole);
  const Device device = select_device(options.device);
  const Engine engine(device, Precision::float64, Precision::float32);
  FitProblem problem(engine, measurement, options.fit);
  const Fit result = fit(problem);
  for (const auto& band : problem.parameters(result.best.u))
    for (const auto& row : parameter_table) fmt::print("{} = {}\n", row.name, shortest(band.*row.member));
  fmt::print("rms {:.4g} cost {:.6g} samples {} converged {} reached {} of {}, {:.2f} s, kernels {:.2f} s, {} evaluations\n",
             problem.rms(result.best.u), result.best.cost, problem.samples(), result.converged, result.reached, result.starts,
             result.seconds, result.kernel_seconds, result.evaluations);
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> fit_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("DATA", options->data,
                  "Measurement: CSV with theta_i_deg, theta_s_deg, phi_deg or phi_s_deg, brdf_per_sr and optionally channel or "
                  "wavelength_nm and sigma")
      ->required();
  parser.add_option("-o,--output", options->output, "Material file to write (TOML)")->required();
  parser.add_option("--channel", options->channel, "The channel to fit, where the measurement has several");
  parser.add_option("--wavelengths", options->wavelengths, "all: fit every channel to one material with bands")
      ->check(CLI::IsMember({"all"}));
  parser.add_option("--share", options->share, "What the bands share: geometry (rho, w_a, w_b, gamma, delta, w, n) or none")
      ->check(CLI::IsMember({"geometry", "none"}));
  parser.add_option("--polarization", options->polarization, "Of the measurement: unpolarized (default), s or p")
      ->check(CLI::IsMember({"unpolarized", "s", "p"}));
  parser.add_option("--fix", options->fixed, "Hold a parameter: k_eff=0. Repeatable")->type_name("NAME=VALUE");
  parser.add_option("--bounds", options->bounds, "Bound a parameter: rho_surface=0.01:2. Repeatable")->type_name("NAME=LOW:HIGH");
  parser.add_option("--model", options->model, "Variant of the model: reflectance_shadowing=surface. Repeatable")
      ->type_name("SWITCH=CHOICE");
  parser.add_option("--starts", options->fit.starts, "Starting points")->check(CLI::Range(1, 10000));
  parser.add_option("--seed", options->fit.seed, "Of the starting points");
  parser.add_option("--max-theta", options->fit.max_theta, "Leave out samples beyond it, degrees")->check(CLI::Range(1., 90.));
  parser.add_option("--floor", options->fit.floor, "Leave out samples below it, 1/sr")->check(CLI::NonNegativeNumber);
  parser.add_option("--weights", options->weights, "aoi: each angle of incidence alike (default), uniform, or sigma")
      ->check(CLI::IsMember({"aoi", "uniform", "sigma"}));
  parser.add_option("--loss", options->loss, "linear (default) or cauchy, which outliers hardly move")
      ->check(CLI::IsMember({"linear", "cauchy"}));
  parser.add_option("--scale", options->measurement.scale, "Factor from the file's values to f in 1/sr")
      ->check(CLI::PositiveNumber);
  parser.add_flag("--flip-azimuth", options->measurement.flip_azimuth, "The file counts azimuth from the backward side");
  parser.add_flag("--force", options->force, "Overwrite an existing material file");
  add_device_option(parser, options->device);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

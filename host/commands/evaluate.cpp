#include "host/compute/evaluate.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <random>

#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/commands/command.hpp"
#include "host/formats/read_material.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string material;
  std::string pairs = "-";
  std::string output;
  std::string engine = "opencl";
  std::string precision;
  std::optional<std::string> device;
  double noise = 0;
  std::uint64_t seed = 1;
  bool force = false;
};

std::vector<DirectionPair> read_pairs(const std::string& file, std::string& source) {
  if (file == "-") {
    source = "standard input";
    return read_directions(std::cin, source);
  }
  source = file;
  std::ifstream in = open_file(file);
  auto pairs = read_directions(in, source);
  if (in.bad()) throw FileError("{}: cannot be read", file);
  return pairs;
}

void check_finite(const Material& material, const Band& band, std::span<const DirectionPair> pairs,
                  std::span<const PolarizedBrdf> values, const std::string& source) {
  for (std::size_t k = 0; k < pairs.size(); ++k)
    if (!std::isfinite(values[k].s) || !std::isfinite(values[k].p))
      throw BadInput(
          "{}:{}: brdf of {} is not finite at theta_i = {}, theta_s = {}, phi = {} degrees: rho_surface = "
          "{}, rho_bulk = {}, rho_retro = {}, w = {} and n = {} make a lobe too narrow there",
          source, pairs[k].line, material.name(), shortest(pairs[k].theta_i), shortest(pairs[k].theta_s),
          shortest(pairs[k].phi), shortest(band.parameters.rho_surface), shortest(band.parameters.rho_bulk),
          shortest(band.parameters.rho_retro), shortest(band.parameters.w), shortest(band.parameters.n));
}

std::string table_text(const Material& material, std::span<const DirectionPair> pairs,
                       const std::vector<std::vector<PolarizedBrdf>>& values, int digits) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  const bool bands = material.has_wavelengths();
  fmt::format_to(out, "{}theta_i_deg,theta_s_deg,phi_deg,brdf_s,brdf_p,brdf\n",
                 bands ? "wavelength_nm," : "");
  for (std::size_t b = 0; b < values.size(); ++b)
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      if (bands) fmt::format_to(out, "{},", shortest(*material.bands()[b].wavelength_nm));
      fmt::format_to(out, "{},{},{},{:.{}g},{:.{}g},{:.{}g}\n", shortest(pairs[k].theta_i),
                     shortest(pairs[k].theta_s), shortest(pairs[k].phi), values[b][k].s, digits,
                     values[b][k].p, digits, values[b][k].unpolarized(), digits);
    }
  return fmt::to_string(text);
}

// As a measurement has it: one factor for s and p of a sample.
void add_noise(std::vector<PolarizedBrdf>& values, const Options& options) {
  if (options.noise == 0) return;
  std::mt19937_64 random(options.seed);
  std::normal_distribution<double> normal;
  for (PolarizedBrdf& value : values) {
    const double factor = std::exp(options.noise * normal(random));
    value.s *= factor;
    value.p *= factor;
  }
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  if (options.material == "-" && options.pairs == "-")
    throw BadInput("MATERIAL and PAIRS cannot both be standard input");
  const Material material = read_material(options.material);
  if (options.engine == "reference" && options.precision == "float32")
    throw BadInput("--engine reference computes in float64 only");
  std::optional<PartialFile> file;
  if (!options.output.empty()) file.emplace(options.output, options.force);
  std::string source;
  const auto pairs = read_pairs(options.pairs, source);
  std::vector<std::vector<PolarizedBrdf>> values;
  int digits = 17;
  if (options.engine == "reference") {
    for (const Band& band : material.bands())
      values.push_back(evaluate_reference(band, material.variant(), pairs, common.watch));
  } else {
    const Device device = select_device(options.device);
    const Precision working = working_precision(options.precision, device);
    const Engine engine(device, working, Precision::float32, common.watch);
    for (const Band& band : material.bands())
      values.push_back(evaluate(engine, band, material.variant(), pairs));
    digits = working == Precision::float64 ? 17 : 9;
  }
  for (auto& band : values) add_noise(band, options);
  for (std::size_t b = 0; b < values.size(); ++b)
    check_finite(material, material.bands()[b], pairs, values[b], source);
  std::string text = table_text(material, pairs, values, digits);
  if (options.noise > 0)
    text = fmt::format("# ln f with noise of standard deviation {}, seed {}\n", shortest(options.noise),
                       options.seed) +
           text;
  if (!file) {
    std::fwrite(text.data(), 1, text.size(), stdout);
    return ExitStatus::done;
  }
  write_whole(*file, text);
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> evaluate_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("MATERIAL", options->material,
                  "Material file (TOML), or a table or simulator's file, for the material inside")
      ->required();
  parser.add_option("PAIRS", options->pairs,
                    "CSV with the columns theta_i_deg, theta_s_deg, phi_deg (or phi_s_deg), in degrees; "
                    "default: standard input");
  parser.add_option("-o,--output", options->output, "CSV file to write; default: standard output");
  add_engine_options(parser, options->engine, options->precision);
  parser
      .add_option("--noise", options->noise,
                  "Adds normal noise of this standard deviation to ln f: a synthetic measurement")
      ->check(CLI::NonNegativeNumber);
  parser.add_option("--seed", options->seed, "Of the noise");
  parser.add_flag("--force", options->force, "Overwrite an existing output");
  add_device_option(parser, options->device);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

#include "host/table/validation/validate.hpp"

#include <nlohmann/json.hpp>

#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"
#include "host/commands/validate_export.hpp"
#include "host/formats/open_table.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string table;
  ValidateOptions validate;
  std::optional<std::size_t> samples;
  ExportValidation exported;
  std::optional<std::string> device;
  bool json = false;
};

using Json = nlohmann::ordered_json;

Json as_json(const StoredTable& table, const Node& node) {
  const auto& [i, p, s, q] = node.index;
  Json json{{"theta_i", table.grid.theta_i[i]},
            {"phi_i", table.grid.phi_i[p]},
            {"theta_s", table.grid.theta_s[s]},
            {"phi_s", table.grid.phi_s[q]}};
  if (const auto wavelength = table.material.bands()[node.band].wavelength_nm)
    json["wavelength_nm"] = *wavelength;
  json["variable"] = brdf_name(table.polarizations[node.polarization]);
  json["stored"] = node.stored;
  json["reference"] = node.expected;
  return json;
}

Json as_json(const InterpolationError& error) {
  if (error.points == 0) return nullptr;
  const auto& at = error.worst;
  Json where{
      {"theta_i", at.angles[0]}, {"phi_i", at.angles[1]}, {"theta_s", at.angles[2]}, {"phi_s", at.angles[3]}};
  if (at.wavelength_nm) where["wavelength_nm"] = *at.wavelength_nm;
  where["interpolated"] = at.interpolated;
  where["model"] = at.model;
  return {{"points", error.points},
          {"max", error.maximum},
          {"95_percent", error.percentile_95},
          {"median", error.median},
          {"worst", where}};
}

Json as_json(const InterpolationKind& kind) {
  return {{"linear", as_json(kind.linear)}, {"ln", as_json(kind.logarithmic)}};
}

Json as_json(const IntegralFindings& findings) {
  return {{"compared_with_reference", findings.compared},
          {"max_relative_error", findings.max_relative_error},
          {"variable", findings.variable},
          {"theta_i", findings.theta_i}};
}

Json as_json(const std::string& file, const StoredTable& table, const Validation& found) {
  const NodeFindings& nodes = found.nodes;
  Json json{{"table", file},
            {"good", found.faults.empty()},
            {"faults", found.faults},
            {"tolerance", found.tolerance}};
  json["nodes"] = {{"in_table", nodes.nodes},
                   {"compared_with_kernels", nodes.screened},
                   {"compared_with_reference", nodes.compared},
                   {"below_1e-30", nodes.negligible},
                   {"over_tolerance", nodes.over_tolerance},
                   {"max_relative_error", nodes.max_relative_error},
                   {"rms_relative_error", nodes.rms_relative_error},
                   {"worst", nodes.worst ? as_json(table, *nodes.worst) : Json(nullptr)}};
  json["positivity"] = {{"negative", nodes.negative}, {"not_finite", nodes.not_finite}};
  json["normalization"] = as_json(found.normalization);
  json["dhr"] = as_json(found.dhr);
  json["reciprocity"] = {{"pairs", found.reciprocity.pairs},     {"median", found.reciprocity.median},
                         {"max", found.reciprocity.maximum},     {"theta_i", found.reciprocity.theta_i},
                         {"theta_s", found.reciprocity.theta_s}, {"phi", found.reciprocity.phi}};
  json["energy"] = {{"max_dhr", found.largest_dhr},
                    {"theta_i", found.largest_dhr_theta_i},
                    {"warnings", found.energy_warnings}};
  if (found.interpolation.cells > 0) {
    Json& interpolation = json["interpolation"] = {{"cells", found.interpolation.cells},
                                                   {"floor", found.interpolation.floor},
                                                   {"cell_centres", as_json(found.interpolation.centre)}};
    for (const auto& row : axis_table) {
      const auto& kind = found.interpolation.along[static_cast<std::size_t>(row.kind)];
      if (kind.linear.points > 0)
        interpolation[std::string("along_") + std::string(row.name)] = as_json(kind);
    }
  }
  return json;
}

std::string line(std::string_view name, const InterpolationError& error) {
  const auto& at = error.worst;
  return fmt::format(
      "  {:<22} {:<10.3g} {:<10.3g} {:<10.3g} theta_i = {:.6g}, phi_i = {:.6g}, theta_s = {:.6g}, phi_s = "
      "{:.6g}{}\n",
      name, error.maximum, error.percentile_95, error.median, at.angles[0], at.angles[1], at.angles[2],
      at.angles[3], at.wavelength_nm ? fmt::format(", {} nm", shortest(*at.wavelength_nm)) : "");
}

std::string interpolation_text(const InterpolationErrors& found) {
  if (found.centre.linear.points == 0) return {};
  std::string text = fmt::format(
      "\ninterpolation error, relative to {}, at {} of {} cells\n  {:<22} {:<10} {:<10} {:<10} worst at "
      "(degrees)\n",
      found.floor > 0 ? fmt::format("f or {} of the slice's peak", found.floor) : "f",
      found.centre.linear.points, found.cells, "", "max", "95 %", "median");
  text += line("cell centres, f", found.centre.linear);
  if (found.centre.logarithmic.points > 0) text += line("cell centres, ln f", found.centre.logarithmic);
  for (const auto& row : axis_table) {
    const auto& kind = found.along[static_cast<std::size_t>(row.kind)];
    if (kind.linear.points > 0) text += line(fmt::format("along {} alone, f", row.name), kind.linear);
  }
  return text;
}

void print_text(const std::string& file, const StoredTable& table, const Validation& found) {
  const NodeFindings& nodes = found.nodes;
  fmt::print("{}: {}\n", file, found.faults.empty() ? "good" : "NOT good");
  for (const auto& fault : found.faults) fmt::print("  fault: {}\n", fault);
  fmt::print(
      "\nnodes          {} compared with the kernels, {} of them with the scalar reference; tolerance "
      "{:.2e}\n",
      nodes.screened, nodes.compared, found.tolerance);
  if (nodes.worst)
    fmt::print("               relative error: max {:.2e}, rms {:.2e}; worst: {}: table {}, reference {}\n",
               nodes.max_relative_error, nodes.rms_relative_error, describe(table, *nodes.worst),
               shortest(nodes.worst->stored), shortest(nodes.worst->expected));
  fmt::print("positivity     {} negative, {} not finite\n", nodes.negative, nodes.not_finite);
  for (const auto& [name, integral] : {std::pair("N", &found.normalization), std::pair("DHR", &found.dhr)})
    fmt::print("{:<14} max relative error {:.2e}{}; {} values compared with the scalar reference\n", name,
               integral->max_relative_error,
               integral->variable.empty() ? ""
                                          : fmt::format(" ({}, theta_i = {} degrees)", integral->variable,
                                                        shortest(integral->theta_i)),
               integral->compared);
  if (found.reciprocity.pairs > 0)
    fmt::print(
        "reciprocity    |ln f(i,s)/f(s,i)| over {} pairs of nodes: median {:.4g}, max {:.4g} at theta_i = "
        "{}, theta_s = {}, phi = {} degrees\n",
        found.reciprocity.pairs, found.reciprocity.median, found.reciprocity.maximum,
        shortest(found.reciprocity.theta_i), shortest(found.reciprocity.theta_s),
        shortest(found.reciprocity.phi));
  fmt::print("energy         largest DHR {:.6g} at theta_i = {} degrees\n", found.largest_dhr,
             shortest(found.largest_dhr_theta_i));
  for (const auto& warning : found.energy_warnings) fmt::print("  warning: {}\n", warning);
  fmt::print("{}", interpolation_text(found.interpolation));
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  if (const ExportFormat* format = options.exported.format_of(options.table))
    return options.exported.run(*format,
                                {.file = options.table,
                                 .directions = options.samples,
                                 .tolerance = options.validate.tolerance,
                                 .device = options.device,
                                 .json = options.json},
                                common.watch);
  ValidateOptions selection = options.validate;
  if (options.samples) selection.nodes.random = *options.samples;
  const auto reader = open_table(options.table);
  const StoredTable table = rebuild(reader->info(), options.table);
  const Device device = select_device(options.device);
  const Engine engine(device, Engine::widest(device), table.precision, common.watch);
  const Validation found = validate(engine, *reader, table, selection);
  if (options.json)
    fmt::print(
        "{}\n",
        as_json(options.table, table, found).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    print_text(options.table, table, found);
  if (found.faults.empty()) return ExitStatus::done;
  throw Error(Fault::check, "{}: {}{}", options.table, found.faults.front(),
              found.faults.size() > 1 ? fmt::format("; and {} more", found.faults.size() - 1) : "");
}

}  // namespace

std::function<ExitStatus()> validate_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  auto& nodes = options->validate.nodes;
  parser
      .add_option("TABLE", options->table,
                  "Table file, the folder of an OpenEXR table in files, or a file for a simulator")
      ->required();
  parser
      .add_option(
          "--samples", options->samples,
          "Random nodes, by a fixed seed, for the scalar reference; default 2000. Of a simulator's file: "
          "random directions at which its consumer's interpolation is compared with the model; default 10000")
      ->check(CLI::Range(std::size_t{0}, std::size_t{10'000'000}));
  parser
      .add_option("--every", nodes.every_row,
                  "Every n-th row of phi_s for the scalar reference; default: about 64 rows")
      ->check(CLI::PositiveNumber);
  parser.add_flag("--all", nodes.all, "Every node, N and DHR against the scalar reference, too");
  parser
      .add_option(
          "--tolerance", options->validate.tolerance,
          "Largest relative error allowed; default: what the table promises (1e-6 in float32, 1e-12 in "
          "float64, and the error of rounding that its attributes tell of). Of a simulator's file: the share "
          "of f by which it may be off beyond what its format reaches at its resolution: in the median, at "
          "95 % of directions and in the mean of each region, and in each value; default 0.001")
      ->check(CLI::PositiveNumber);
  parser.add_flag("--json", options->json, "As JSON");
  add_device_option(parser, options->device);
  options->exported.add(parser);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

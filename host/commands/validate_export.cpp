#include "host/commands/validate_export.hpp"

#include <nlohmann/json.hpp>

#include "host/base/numbers.hpp"
#include "host/commands/options/format_choice.hpp"
#include "host/formats/export/export_verdict.hpp"
#include "host/formats/read_material.hpp"

namespace brdftab {
namespace {

constexpr const char* group = "Files for simulators";
using Json = nlohmann::ordered_json;

Json as_json(const ConsumerError& error) {
  return {{"values", error.values},
          {"median", error.median},
          {"95_percent", error.percentile_95},
          {"max", error.maximum},
          {"worst",
           {{"theta_i", error.theta_i},
            {"theta_s", error.theta_s},
            {"phi", error.phi},
            {"channel", error.channel},
            {"consumer", error.consumer},
            {"model", error.model}}}};
}

Json as_json(const ExportVerdict& verdict) {
  Json regions = Json::array();
  for (const RegionErrors& region : verdict.regions) {
    Json entry{{"region", region.name}, {"channel", region.channel}, {"directions", region.directions}};
    for (std::size_t k = 0; k < statistic_names.size(); ++k) {
      const RegionStatistic& found = region.statistics[k];
      entry[k == 1 ? "95_percent" : std::string(statistic_names[k])] = {
          {"file", found.file}, {"reached", found.reached}, {"allowed", found.allowed}};
    }
    regions.push_back(std::move(entry));
  }
  return regions;
}

Json as_json(const ValueErrors& values) {
  return {{"compared", values.values()},
          {"over_tolerance", values.wrong()},
          {"rounding", values.rounding()},
          {"max", values.maximum()},
          {"worst", {{"place", values.place()}, {"file", values.held()}, {"right", values.right()}}}};
}

Json as_json(AngleRange range) { return {range.first, range.last}; }

void print_row(std::string_view name, const ConsumerError& error) {
  fmt::print(
      "  {:<34} {:<10.3g} {:<10.3g} {:<10.3g} theta_i = {:.6g}, theta_s = {:.6g}, phi = {:.6g}: {:.6g}, "
      "model {:.6g} 1/sr\n",
      name, error.median, error.percentile_95, error.maximum, error.theta_i, error.theta_s, error.phi,
      error.consumer, error.model);
}

void print_verdict(const ExportVerdict& verdict) {
  fmt::print(
      "\nthe file's errors / what its format reaches, and the mean of f read - f; allowed beyond that is {} "
      "of f\n"
      "  {:<28} {:<24} {:<24} {}\n",
      shortest(verdict.tolerance), "", statistic_names[0], statistic_names[1], statistic_names[2]);
  for (const RegionErrors& region : verdict.worst_channels()) {
    std::string row = fmt::format("  {:<28}", region.name);
    for (const RegionStatistic& found : region.statistics)
      row += fmt::format(" {:<24}", fmt::format("{:.4g} / {:.4g}{}", found.file, found.reached,
                                                found.excess() > 0 ? " NOT good" : ""));
    fmt::print("{}\n", row + (region.channel == "f" ? "" : region.channel));
  }
  const ValueErrors& values = verdict.values;
  fmt::print(
      "values         {} compared with the model's: largest error {:.3g} of f{}, {}: {:.9g}, right is "
      "{:.9g}\n",
      values.values(), values.maximum(),
      values.rounding() > 0 ? fmt::format(" beyond {:.1g} by its digits", values.rounding()) : "",
      values.place(), values.held(), values.right());
}

struct Findings {
  ExportDirections directions;
  ExportErrors errors;
  ExportVerdict verdict;
};

Findings findings(const ExportReader& table, const ExportModel& source,
                  const ExportValidation::Request& request) {
  try {
    const ExportDirections directions =
        export_directions(table, request.directions.value_or(default_directions));
    const ReadExport read = read_export(table, source, directions);
    return {directions, export_errors(read, source),
            export_verdict(table, source, read, request.tolerance.value_or(default_export_tolerance))};
  } catch (const BadInput& fault) {
    throw BadInput("{}: {}", request.file, fault.what());
  }
}

Json as_json(const std::string& file, const ExportFormat& format, const ExportReader& table,
             const Findings& found) {
  const FormatTraits& traits = format.traits();
  const ExportErrors& errors = found.errors;
  return {
      {"file", file},
      {"format", traits.name},
      {"good", found.verdict.good()},
      {"fault", found.verdict.fault()},
      {"tolerance", found.verdict.tolerance},
      {"interpolation", table.interpolation()},
      {"error_floor", error_floor},
      {"drawn",
       {{"theta_i", as_json(found.directions.theta_i)},
        {"theta_s", as_json(found.directions.theta_s)},
        {"phi", as_json(found.directions.phi)},
        {"share", found.directions.share}}},
      {"uniform", as_json(errors.uniform)},
      {"near_peaks", as_json(errors.near_peaks)},
      {"regions", as_json(found.verdict)},
      {"values", as_json(found.verdict.values)},
      {"not_held",
       {{"reciprocity_defect", !traits.holds_non_reciprocal}, {"polarization", !traits.holds_polarization}}},
      {"reciprocity", {{"median", errors.reciprocity_median}, {"max", errors.reciprocity_maximum}}},
      {"polarization", {{"median", errors.polarization_median}, {"max", errors.polarization_maximum}}}};
}

void print_text(const std::string& file, const ExportFormat& format, const ExportReader& table,
                const Findings& found) {
  const ExportDirections& drawn = found.directions;
  const ExportErrors& errors = found.errors;
  fmt::print("{}: {}: {}\n", file, format.traits().name, found.verdict.good() ? "good" : "NOT good");
  if (!found.verdict.good()) fmt::print("  fault: {}\n", found.verdict.fault());
  fmt::print(
      "\n|f read - f| / max(f, {} 1/sr), f read by {}\nat directions where the file has samples: theta_i "
      "{:.6g} to {:.6g}, theta_s {:.6g} to {:.6g}, phi {:.6g} to {:.6g} degrees, {:.3g} % of all pairs\n",
      error_floor, table.interpolation(), drawn.theta_i.first, drawn.theta_i.last, drawn.theta_s.first,
      drawn.theta_s.last, drawn.phi.first, drawn.phi.last, 100 * drawn.share);
  fmt::print("  {:<34} {:<10} {:<10} {:<10} worst at (degrees)\n", "", "median", "95 %", "max");
  print_row("directions uniform in solid angle", errors.uniform);
  print_row("near mirror and retro directions", errors.near_peaks);
  print_verdict(found.verdict);
  const auto held = [](bool is) { return is ? "held" : "NOT held"; };
  fmt::print(
      "\nreciprocity    defect {} by the format: |ln f(i,s)/f(s,i)| of the model: median {:.4g}, max "
      "{:.4g}\n",
      held(format.traits().holds_non_reciprocal), errors.reciprocity_median, errors.reciprocity_maximum);
  fmt::print(
      "polarisation   {} by the format: |f_s - f_p|/(f_s + f_p) of the model: median {:.4g}, max {:.4g}\n",
      held(format.traits().holds_polarization), errors.polarization_median, errors.polarization_maximum);
}

}  // namespace

void ExportValidation::add(CLI::App& parser) {
  parser.option_defaults()->group(group);
  parser.add_option("--material", material_,
                    "The material, or a table that carries it, of a file that cannot hold its text");
  parser.add_option("--wavelength", wavelength_nm_,
                    "The band that the file holds, nm, where it cannot say so");
  parser
      .add_option("--illuminant", illuminant_,
                  "The illuminant of its colours, D65 or E, where it cannot say so; D65")
      ->check(CLI::IsMember(std::vector<std::string>(illuminant_names.begin(), illuminant_names.end())));
  for (const auto& format : formats_)
    for (const FormatOption& row : format->options())
      if (row.is_for_reading) add_format_option(parser, row);
  parser.option_defaults()->group("Options");
}

const ExportFormat* ExportValidation::format_of(const std::string& file) const {
  const Format* format = recognised_format(formats_, file);
  return format ? format->as_export() : nullptr;
}

ExportModel ExportValidation::source(const Engine& engine, const ExportReader& table,
                                     const Request& request) const {
  if (!material_ && table.material_text().empty())
    throw BadInput("{}: its format cannot hold the material: --material FILE names it", request.file);
  const Material whole = material_ ? read_material(*material_) : material_of(table, request.file);
  Material material = wavelength_nm_ ? whole.at_wavelength(*wavelength_nm_) : in_bands_of(table, whole);
  Illuminant illuminant = table.illuminant();
  if (illuminant_)
    illuminant = *illuminant_ == name_of(Illuminant::d65) ? Illuminant::d65 : Illuminant::equal_energy;
  return ExportModel(engine, std::move(material), {.grid = {}, .illuminant = illuminant, .history = {}});
}

ExitStatus ExportValidation::run(const ExportFormat& format, const Request& request,
                                 const Watch& watch) const {
  const auto table = format.read(request.file);
  const Device device = select_device(request.device);
  const Engine engine(device, Engine::widest(device), Precision::float32, watch);
  const Findings found = findings(*table, source(engine, *table, request), request);
  if (request.json)
    fmt::print("{}\n", as_json(request.file, format, *table, found)
                           .dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  else
    print_text(request.file, format, *table, found);
  if (found.verdict.good()) return ExitStatus::done;
  throw Error(Fault::check, "{}: {}", request.file, found.verdict.fault());
}

}  // namespace brdftab

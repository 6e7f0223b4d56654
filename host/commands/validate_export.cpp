#include "host/commands/validate_export.hpp"

#include <nlohmann/json.hpp>

#include "host/commands/output_plan.hpp"
#include "host/export_errors.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

constexpr const char* group = "Files for simulators";
constexpr std::size_t default_directions = 10'000;
// A share of f: beyond it in the median, the file is not one of this material.
constexpr double default_tolerance = 0.25;

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

void print_row(std::string_view name, const ConsumerError& error) {
  fmt::print(
      "  {:<34} {:<10.3g} {:<10.3g} {:<10.3g} theta_i = {:.6g}, theta_s = {:.6g}, phi = {:.6g}: {:.6g}, model {:.6g} 1/sr\n",
      name, error.median, error.percentile_95, error.maximum, error.theta_i, error.theta_s, error.phi, error.consumer,
      error.model);
}

}  // namespace

void ExportValidation::add(CLI::App& parser) {
  parser.option_defaults()->group(group);
  parser.add_option("--material", material_, "The material, or a table that carries it, of a file that cannot hold its text");
  parser.add_option("--wavelength", wavelength_nm_, "The band that the file holds, nm, where it cannot say so");
  parser.add_option("--illuminant", illuminant_, "The illuminant of its colours, D65 or E, where it cannot say so; D65")
      ->check(CLI::IsMember(std::vector<std::string>(illuminant_names.begin(), illuminant_names.end())));
  for (const auto& format : formats_) format->add_reading_options(parser);
  parser.option_defaults()->group("Options");
}

ExportSource ExportValidation::source(const Engine& engine, const ExportedTable& table, const Request& request) const {
  if (!material_ && table.material_text().empty())
    throw BadInput("{}: its format cannot hold the material: --material FILE names it", request.file);
  Material material =
      material_ ? read_material(*material_) : Material::parse(table.material_text(), fmt::format("{}, material", request.file));
  const auto wavelengths = table.wavelengths_nm();
  if (wavelength_nm_)
    material = material.at_wavelength(*wavelength_nm_);
  else if (wavelengths.size() == 1 && material.bands().size() > 1)
    material = material.at_wavelength(wavelengths.front());
  Illuminant illuminant = table.illuminant();
  if (illuminant_) illuminant = *illuminant_ == name_of(Illuminant::d65) ? Illuminant::d65 : Illuminant::equal_energy;
  return ExportSource(engine, std::move(material), {.grid = {}, .illuminant = illuminant, .history = {}});
}

ExitStatus ExportValidation::run(const ExportFormat& format, const Request& request) const {
  const auto table = format.read(request.file);
  const Device device = select_device(request.device);
  const Engine engine(device, Engine::widest(device), Precision::float32);
  const ExportErrors found =
      export_errors(*table, source(engine, *table, request), request.directions.value_or(default_directions));
  const double tolerance = request.tolerance.value_or(default_tolerance);
  const bool good = found.uniform.median <= tolerance;
  if (request.json) {
    const Json json{
        {"file", request.file},
        {"format", format.traits().name},
        {"good", good},
        {"tolerance", tolerance},
        {"interpolation", table->interpolation()},
        {"error_floor", error_floor},
        {"uniform", as_json(found.uniform)},
        {"near_peaks", as_json(found.near_peaks)},
        {"not_held",
         {{"reciprocity_defect", !format.traits().holds_non_reciprocal}, {"polarization", !format.traits().holds_polarization}}},
        {"reciprocity", {{"median", found.reciprocity_median}, {"max", found.reciprocity_maximum}}},
        {"polarization", {{"median", found.polarization_median}, {"max", found.polarization_maximum}}}};
    fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
  } else {
    fmt::print("{}: {}: {}\n\n|f read - f| / max(f, {} 1/sr), f read by {}\n", request.file, format.traits().name,
               good ? "good" : "NOT good", error_floor, table->interpolation());
    fmt::print("  {:<34} {:<10} {:<10} {:<10} worst at (degrees)\n", "", "median", "95 %", "max");
    print_row("directions uniform in solid angle", found.uniform);
    print_row("near mirror and retro directions", found.near_peaks);
    const auto held = [](bool is) { return is ? "held" : "NOT held"; };
    fmt::print("\nreciprocity    defect {} by the format: |ln f(i,s)/f(s,i)| of the model: median {:.4g}, max {:.4g}\n",
               held(format.traits().holds_non_reciprocal), found.reciprocity_median, found.reciprocity_maximum);
    fmt::print("polarisation   {} by the format: |f_s - f_p|/(f_s + f_p) of the model: median {:.4g}, max {:.4g}\n",
               held(format.traits().holds_polarization), found.polarization_median, found.polarization_maximum);
  }
  if (good) return ExitStatus::done;
  throw Error(ExitStatus::check_failed, "{}: f is off by {:.3g} of it in the median, more than {}", request.file,
              found.uniform.median, shortest(tolerance));
}

}  // namespace brdftab

#include <cstdio>

#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"
#include "host/compute/integrals.hpp"
#include "host/formats/read_material.hpp"
#include "host/table/energy.hpp"

namespace brdftab {
namespace {

struct Options {
  std::string material;
  std::optional<std::string> theta_i;
  std::string polarization = "unpolarized";
  std::string engine = "opencl";
  std::string precision;
  std::optional<std::string> device;
};

Polarization polarization_of(const std::string& name) {
  return name == "s" ? Polarization::s : name == "p" ? Polarization::p : Polarization::unpolarized;
}

// BHR needs every angle; where N leaves the range of numbers at one of them, the line says so.
std::string bhr_line(const std::optional<Engine>& engine, const Band& band, const Variant& variant,
                     Polarization polarization, int digits) {
  const std::string wavelength =
      band.wavelength_nm ? fmt::format(" at {} nm", shortest(*band.wavelength_nm)) : "";
  try {
    const Bhr albedo = engine ? bhr(*engine, band, variant) : reference_bhr(band, variant);
    return fmt::format("# bhr = {:.{}g}{}\n# bhr_relative_error = {:.1e}\n", albedo.of(polarization), digits,
                       wavelength, albedo.error);
  } catch (const BadInput& error) {
    return fmt::format("# bhr{} is not computed: {}\n", wavelength, error.what());
  }
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  const Material material = read_material(options.material);
  const Axis theta_i =
      options.theta_i ? parse_axis_option(AxisKind::theta_i, *options.theta_i) : material.grid().theta_i;
  const Polarization polarization = polarization_of(options.polarization);
  std::optional<Engine> engine;
  int digits = 17;
  if (options.engine == "opencl") {
    const Device device = select_device(options.device);
    const Precision working = working_precision(options.precision, device);
    engine.emplace(device, working, Precision::float32, common.watch);
    digits = working == Precision::float64 ? 17 : 9;
  } else if (options.precision == "float32") {
    throw BadInput("--engine reference computes in float64 only");
  }

  std::string text = material.has_wavelengths() ? "wavelength_nm," : "";
  text += "theta_i_deg,N_surface,N_bulk,N_retro,dhr,dhr_surface,dhr_bulk,dhr_retro\n";
  for (const Band& band : material.bands()) {
    const Integrals at = engine
                             ? integrals(*engine, band, material.variant(), theta_i.nodes())
                             : reference_integrals(band, material.variant(), theta_i.nodes(), common.watch);
    for (std::size_t k = 0; k < theta_i.size(); ++k) {
      if (band.wavelength_nm) text += shortest(*band.wavelength_nm) + ",";
      text += shortest(theta_i[k]);
      for (const auto& n : at.normalization.value) text += fmt::format(",{:.{}g}", n[k], digits);
      text += fmt::format(",{:.{}g}", at.dhr.total(k, polarization), digits);
      for (std::size_t lobe = 0; lobe < 3; ++lobe)
        text += fmt::format(",{:.{}g}", at.dhr.lobe(lobe, k, polarization), digits);
      text += '\n';
    }
    text += bhr_line(engine, band, material.variant(), polarization, digits);
    const Reciprocity defect =
        engine ? reciprocity(band, material.variant()) : reference_reciprocity(band, material.variant());
    text += fmt::format(
        "# reciprocity of {} pairs: median {:.4g}, 90 % {:.4g}, maximum {:.4g} at theta_i = {}, theta_s = "
        "{}, phi = {} degrees; {}\n",
        defect.pairs, defect.median, defect.percentile_90, defect.maximum, defect.theta_i, defect.theta_s,
        defect.phi, reciprocity_grid);
    for (const auto& warning : energy_warnings(material, band, theta_i.nodes(), at.dhr, {polarization}))
      say(common, "warning: " + warning);
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> integrate_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser
      .add_option("MATERIAL", options->material,
                  "Material file (TOML), or a table or simulator's file, for the material inside")
      ->required();
  parser.add_option("--theta-i", options->theta_i,
                    "Polar angles of incidence, degrees: start:stop:step, or angles separated by commas; "
                    "default: the material's");
  parser.add_option("--polarization", options->polarization, "unpolarized (default), s or p")
      ->check(CLI::IsMember({"unpolarized", "s", "p"}));
  add_engine_options(parser, options->engine, options->precision);
  add_device_option(parser, options->device);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

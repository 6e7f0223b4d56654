#include "host/commands/options/export_option.hpp"

#include "host/base/error.hpp"
#include "host/formats/export/write_export.hpp"

namespace brdftab {
namespace {

constexpr const char* shared_group = "Files for simulators";

}  // namespace

void ExportOption::add(CLI::App& parser) {
  parser
      .add_option("--wavelength", wavelength_nm_,
                  "Only the band at this wavelength, nm, of a material that has several; formats that hold "
                  "one band need it")
      ->group(shared_group);
  parser.add_option("--illuminant", illuminant_, "For colours from bands: D65 (default), or E: equal energy")
      ->check(CLI::IsMember(std::vector<std::string>(illuminant_names.begin(), illuminant_names.end())))
      ->group(shared_group);
}

void ExportOption::check(const CLI::App& parser, const Format& chosen) const {
  const auto refuse = [&](const CLI::Option* option, std::string_view belongs) {
    if (option->count() > 0)
      throw BadInput("{} is for {}; the file is {}", option->get_name(), belongs,
                     chosen.as_dense() ? "a dense table" : chosen.traits().name);
  };
  for (const CLI::Option* option : parser.get_options()) {
    if (chosen.as_export() && option->get_group() == dense_group)
      refuse(option, "dense tables, hdf5 and exr");
    if (chosen.as_dense() && option->get_group() == shared_group) refuse(option, "simulators' files");
    if (chosen.as_export() && !chosen.traits().takes_axes && option->get_group() == axes_group)
      refuse(option, "formats whose axes are free");
  }
}

Material ExportOption::material_for(const ExportFormat& format, const MaterialOutput& output,
                                    const Grid& grid) const {
  Material material = wavelength_nm_ ? output.material.at_wavelength(*wavelength_nm_) : output.material;
  try {
    check_holds(format, material, grid);
  } catch (const BadInput& refusal) {
    throw BadInput("{}: {}", output.input, refusal.what());
  }
  return material;
}

Illuminant ExportOption::illuminant() const {
  return illuminant_ == name_of(Illuminant::d65) ? Illuminant::d65 : Illuminant::equal_energy;
}

}  // namespace brdftab

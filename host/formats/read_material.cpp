#include "host/formats/read_material.hpp"

#include "host/base/error.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/open_table.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {
namespace {

Material material_of(const TableReader& table, const std::string& file) {
  const AttributeValue* text = table.info().attribute("material");
  const auto* found = text ? std::get_if<std::string>(text) : nullptr;
  if (!found) throw BadInput("{}: has no attribute material: it is no table of this program", file);
  return Material::parse(*found, fmt::format("{}, attribute material", file));
}

}  // namespace

Material material_of(const ExportReader& table, const std::string& file) {
  if (table.material_text().empty()) throw BadInput("{}: its format cannot hold the material", file);
  return Material::parse(table.material_text(), fmt::format("{}, material", file));
}

Material in_bands_of(const ExportReader& table, const Material& material) {
  const auto wavelengths = table.wavelengths_nm();
  return wavelengths.size() == 1 && material.bands().size() > 1 ? material.at_wavelength(wavelengths.front())
                                                                : material;
}

Material read_material(const std::filesystem::path& file) {
  std::error_code error;
  // A pipe can be read once only, as a material.
  if (std::filesystem::is_regular_file(file, error)) {
    const Formats formats = all_formats();
    const Format* format = recognised_format(formats, file);
    if (format && format->as_export()) {
      const auto table = format->as_export()->read(file);
      return in_bands_of(*table, material_of(*table, file.string()));
    }
  }
  if (is_table(file)) return material_of(*open_table(file), file.string());
  return Material::read(file);
}

}  // namespace brdftab

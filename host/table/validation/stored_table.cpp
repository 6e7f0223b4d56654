#include "host/table/validation/stored_table.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/table/table_attributes.hpp"

namespace brdftab {
namespace {

using Names = std::vector<std::string>;

class Rebuilder {
 public:
  Rebuilder(const TableInfo& info, const std::string& file) : info_(info), file_(file) {}

  StoredTable rebuild() {
    const Material material = read_material();
    Grid grid;
    Names dimensions;
    std::vector<std::size_t> shape;
    if (material.has_wavelengths()) {
      check_wavelengths(material);
      dimensions.push_back("wavelength");
      shape.push_back(material.bands().size());
    }
    for (const auto& row : axis_table) {
      grid[row.kind] = read_axis(row);
      dimensions.emplace_back(row.name);
      shape.push_back(grid[row.kind].size());
    }
    StoredTable table{
        .material = material,
        .grid = grid,
        .polarizations = {},
        .precision = Precision::float32,
        .working = text("working_precision") == "float32" ? Precision::float32 : Precision::float64,
        .promised = 0,
        .faults = {}};
    std::string type;
    for (const Polarization polarization : {Polarization::unpolarized, Polarization::s, Polarization::p}) {
      const VariableInfo* samples = info_.variable(brdf_name(polarization));
      if (!samples) continue;
      check_variable(*samples, dimensions, shape, "sr-1");
      if (samples->type != "float32" && samples->type != "float64")
        fail("{} is of type {}, not float32 or float64", samples->name, samples->type);
      if (!type.empty() && samples->type != type)
        fail("{} is {}, but another brdf is {}", samples->name, samples->type, type);
      type = samples->type;
      table.polarizations.push_back(polarization);
    }
    if (type.empty()) fail("has no variable brdf, brdf_s or brdf_p");
    table.precision = type == "float64" ? Precision::float64 : Precision::float32;
    dimensions.resize(dimensions.size() - 3);
    shape.resize(shape.size() - 3);
    for (const auto& integral : integral_variables({})) {
      const VariableInfo* stored = info_.variable(integral.name);
      if (!stored) fail("has no variable {}", integral.name);
      check_variable(*stored, dimensions, shape, "1");
    }
    table.promised = promised_error(table.precision) + rounding(table.faults);
    compare_attributes(table);
    return table;
  }

 private:
  template <class... Args>
  [[noreturn]] void fail(fmt::format_string<Args...> format, Args&&... args) const {
    throw Error(Fault::check, "{}: {}", file_, fmt::format(format, std::forward<Args>(args)...));
  }

  std::string text(std::string_view name) const {
    const AttributeValue* value = info_.attribute(name);
    const auto* found = value ? std::get_if<std::string>(value) : nullptr;
    return found ? *found : "";
  }

  Material read_material() const {
    try {
      return Material::parse(text("material"), "attribute material");
    } catch (const BadInput& error) {
      fail("the material's text has been edited or is damaged: {}", error.what());
    }
  }

  const VariableInfo& coordinate(std::string_view name, std::string_view units) const {
    const VariableInfo* variable = info_.variable(name);
    if (!variable) fail("has no axis {}", name);
    if (variable->shape.size() != 1) fail("axis {} has {} dimensions, not one", name, variable->shape.size());
    if (variable->units != units)
      fail("axis {} is in units '{}', not '{}'", name, excerpt(variable->units), units);
    return *variable;
  }

  Axis read_axis(const AxisRow& row) const {
    const VariableInfo& variable = coordinate(row.name, "degree");
    try {
      return Axis(row.kind, variable.values);
    } catch (const BadInput& error) {
      fail("the axis has been edited or is damaged: {}", error.what());
    }
  }

  void check_wavelengths(const Material& material) const {
    const VariableInfo& wavelength = coordinate("wavelength", "nm");
    std::vector<double> expected;
    for (const Band& band : material.bands()) expected.push_back(*band.wavelength_nm);
    if (wavelength.values != expected)
      fail("axis wavelength has {} nm, but the bands of the material's text are {} nm",
           fmt::join(wavelength.values, ", "), fmt::join(expected, ", "));
  }

  void check_variable(const VariableInfo& variable, const Names& dimensions,
                      const std::vector<std::size_t>& shape, std::string_view units) const {
    Names sorted = variable.dimensions, expected = dimensions;
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    if (variable.dimensions != dimensions)
      fail("{} has the dimensions [{}], not [{}]{}", variable.name, fmt::join(variable.dimensions, ", "),
           fmt::join(dimensions, ", "), sorted == expected ? ": axes are swapped" : "");
    if (variable.shape != shape) {
      std::vector<std::size_t> sizes = variable.shape, wanted = shape;
      std::sort(sizes.begin(), sizes.end());
      std::sort(wanted.begin(), wanted.end());
      fail("{} has {} nodes, but its axes have {}{}", variable.name, fmt::join(variable.shape, " x "),
           fmt::join(shape, " x "), sizes == wanted ? ": axes are swapped" : "");
    }
    if (variable.units != units)
      fail("{} is in units '{}', not '{}'", variable.name, excerpt(variable.units), units);
  }

  // Bits that were dropped on writing: half a unit of the last one kept, at most.
  double rounding(std::vector<std::string>& faults) const {
    const AttributeValue* bits = info_.attribute("keep_bits");
    const AttributeValue* error = info_.attribute("keep_bits_relative_error");
    if (!bits && !error) return 0;
    const auto* kept = bits ? std::get_if<double>(bits) : nullptr;
    const auto* relative = error ? std::get_if<double>(error) : nullptr;
    if (!kept || !relative || !(*kept >= 1) || !(*relative >= 0 && *relative <= std::exp2(-*kept))) {
      faults.push_back("attributes keep_bits and keep_bits_relative_error contradict each other");
      return 0;
    }
    return *relative;
  }

  static std::string shown(const AttributeValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return fmt::format("'{}'", excerpt(*text, 40));
    if (const auto* number = std::get_if<double>(&value)) return shortest(*number);
    return fmt::format("{}", fmt::join(std::get<std::vector<double>>(value), ", "));
  }

  void compare_attributes(StoredTable& table) const {
    auto expected = material_attributes(table.material);
    expected.push_back({"title", fmt::format("BRDF of {}", table.material.name())});
    expected.push_back({"azimuth_convention", std::string(azimuth_convention)});
    expected.push_back({"grid_registration", std::string("node")});
    for (const auto& attribute : expected) {
      const AttributeValue* stored = info_.attribute(attribute.name);
      if (!stored)
        table.faults.push_back(fmt::format("attribute {} is missing", attribute.name));
      else if (*stored != attribute.value)
        table.faults.push_back(fmt::format(
            "attribute {} is {}, but {} {}: edited after the table was made", attribute.name, shown(*stored),
            attribute.name == "azimuth_convention" || attribute.name == "grid_registration"
                ? "this program writes"
                : "the material's text says",
            shown(attribute.value)));
    }
  }

  const TableInfo& info_;
  const std::string& file_;
};

}  // namespace

StoredTable rebuild(const TableInfo& info, const std::string& file) {
  return Rebuilder(info, file).rebuild();
}

}  // namespace brdftab

#include "host/model/material/material_reader.hpp"

#include <fmt/ranges.h>

#include <algorithm>

#include "host/base/numbers.hpp"
#include "host/model/material/fit_comments.hpp"
#include "host/model/material/fit_reader.hpp"
#include "host/model/material/toml_document.hpp"
#include "host/model/variant.hpp"

namespace brdftab {
namespace {

class MaterialReader {
 public:
  MaterialReader(const std::string& text, const std::string& source) : text_(text), toml_(text, source) {}

  MaterialContent read() {
    const toml::table& root = toml_.root();
    toml_.check_keys(
        root, "", {"name", "description", "source", "license", "parameters", "model", "band", "fit", "grid"});
    read_name(root);
    content_.description = toml_.text(root, "", "description");
    content_.source = toml_.text(root, "", "source");
    content_.license = toml_.text(root, "", "license");
    read_model(root);
    read_parameters(root);
    content_.fit = read_fit(toml_, content_.bands.size());
    if (!content_.fit) content_.fit = fit_in_comments(text_, content_.bands);
    read_grid(root);
    return std::move(content_);
  }

 private:
  void read_name(const toml::table& root) {
    const toml::node* node = root.get("name");
    if (!node) toml_.refuse(root.source(), "name is missing: a string is required");
    content_.name = toml_.text("name", *node);
    if (trimmed(content_.name).empty()) toml_.refuse("name", *node, "must not be empty");
  }

  double parameter(const ParameterRow& row, std::string_view prefix, const toml::node& node) const {
    return toml_.number(fmt::format("{}{}", prefix, row.name), node, row.minimum, row.maximum);
  }

  void read_parameters(const toml::table& root) {
    const toml::table* table = toml_.optional_table(root, "", "parameters");
    if (!table)
      toml_.refuse(root.source(), fmt::format("[parameters] is missing: it must give {}",
                                              fmt::join(parameter_names(), ", ")));
    toml_.check_keys(*table, "parameters.", parameter_names());
    Parameters parameters{};
    for (const auto& row : parameter_table) {
      const toml::node* node = table->get(row.name);
      if (!node)
        toml_.refuse(table->source(),
                     fmt::format("parameters.{} is missing: a number from {} to {} is required ({})",
                                 row.name, row.minimum, row.maximum, row.meaning));
      parameters.*row.member = parameter(row, "parameters.", *node);
    }
    read_bands(root, parameters);
  }

  void read_bands(const toml::table& root, const Parameters& parameters) {
    const toml::node* node = root.get("band");
    if (!node) {
      content_.bands.push_back({std::nullopt, parameters});
      return;
    }
    const toml::array* bands = node->as_array();
    if (!bands || bands->empty() || !bands->is_array_of_tables())
      toml_.refuse("band", *node, "must be one or more tables, each headed [[band]]");
    auto known = parameter_names();
    known.insert(known.begin(), {"wavelength_nm", "fit"});
    for (const auto& element : *bands) {
      const toml::table& table = *element.as_table();
      toml_.check_keys(table, "band.", known);
      Band band{wavelength(table), parameters};
      for (const auto& row : parameter_table)
        if (const toml::node* value = table.get(row.name))
          band.parameters.*row.member = parameter(row, "band.", *value);
      content_.bands.push_back(band);
    }
  }

  double wavelength(const toml::table& band) const {
    const toml::node* node = band.get("wavelength_nm");
    if (!node)
      toml_.refuse(band.source(), "band.wavelength_nm is missing: a number above 0, in nm, is required");
    const std::string allowed = "in nm, above 0 and at most 1e9";
    const double value = toml_.number("band.wavelength_nm", *node, allowed);
    if (value <= 0 || value > 1e9) toml_.refuse("band.wavelength_nm", *node, "must be " + allowed);
    if (!content_.bands.empty() && value <= *content_.bands.back().wavelength_nm)
      toml_.refuse(
          "band.wavelength_nm", *node,
          fmt::format("must be above the band before it, {} nm", *content_.bands.back().wavelength_nm));
    return value;
  }

  void read_model(const toml::table& root) {
    const toml::table* table = toml_.optional_table(root, "", "model");
    if (!table) return;
    std::vector<std::string_view> names;
    for (const auto& row : variant_table()) names.push_back(row.name);
    toml_.check_keys(*table, "model.", names);
    for (const auto& row : variant_table())
      if (const toml::node* node = table->get(row.name))
        row.set(content_.variant,
                static_cast<int>(toml_.choice(fmt::format("model.{}", row.name), *node, row.choices)));
    if (content_.variant.normalization == Normalization::closed_form &&
        content_.variant.autocovariance == Autocovariance::gaussian)
      toml_.refuse(
          "model.normalization", *table->get("normalization"),
          "Eq. (8) normalises a Lorentzian; a gaussian autocovariance takes hemispherical or reciprocal");
  }

  void read_grid(const toml::table& root) {
    const toml::table* table = toml_.optional_table(root, "", "grid");
    if (!table) return;
    std::vector<std::string_view> names;
    for (const auto& row : axis_table) names.push_back(row.name);
    toml_.check_keys(*table, "grid.", names);
    for (const auto& row : axis_table)
      if (const toml::node* node = table->get(row.name))
        content_.grid[row.kind] = axis(fmt::format("grid.{}", row.name), row.kind, *node);
  }

  Axis axis(const std::string& name, AxisKind kind, const toml::node& node) const {
    std::vector<double> nodes;
    if (!node.is_string())
      for (const auto& element :
           toml_.array(name, node, "must be \"start:stop:step\" or an array of numbers, in degrees"))
        nodes.push_back(toml_.number(name, element, "in degrees"));
    try {
      return node.is_string() ? Axis::parse(kind, **node.as_string()) : Axis(kind, std::move(nodes));
    } catch (const BadInput& error) {
      toml_.refuse(name, node, error.what());
    }
  }

  const std::string& text_;
  TomlDocument toml_;
  MaterialContent content_;
};

}  // namespace

MaterialContent read_material_content(const std::string& text, const std::string& source) {
  return MaterialReader(text, source).read();
}

}  // namespace brdftab

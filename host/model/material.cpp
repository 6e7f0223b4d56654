#include "host/model/material.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <numeric>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/variant.hpp"

namespace brdftab {
namespace {

/// A fault whose message names its place.
class PlacedFault : public BadInput {
 public:
  using BadInput::BadInput;
};

// The parser recurses over the parts of a dotted key.
constexpr std::ptrdiff_t most_dots_of_a_key = 64;

// Where a column, which counts characters, begins in a line of UTF-8.
std::size_t byte_of_column(std::string_view line, std::size_t column) {
  std::size_t at = 0;
  for (std::size_t k = 1; k < column && at < line.size(); ++k) {
    ++at;
    while (at < line.size() && (static_cast<unsigned char>(line[at]) & 0xc0) == 0x80) ++at;
  }
  return at;
}

std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row.back();
}

std::string joined(const std::vector<std::string_view>& words) {
  return fmt::format("{}", fmt::join(words, ", "));
}

std::string_view type_name(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "an array";
    case toml::node_type::string:
      return "a string";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "a boolean";
    default:
      return "a date or time";
  }
}

}  // namespace

/// Turns TOML into a Material, or into one line that says where and what is wrong.
class MaterialReader {
 public:
  MaterialReader(std::string text, std::string source) : source_(std::move(source)) {
    material_.text_ = std::move(text);
    for (std::string_view rest = material_.text_;;) {
      const auto end = rest.find('\n');
      lines_.push_back(rest.substr(0, end));
      if (end == std::string_view::npos) break;
      rest.remove_prefix(end + 1);
    }
  }

  Material read() {
    check_is_text();
    toml::table root;
    try {
      root = toml::parse(std::string_view(material_.text_), std::string_view(source_));
    } catch (const toml::parse_error& error) {
      fail(error.source(), std::string(error.description()));
    }
    check_keys(root, "", {"name", "description", "source", "license", "parameters", "model", "band", "grid"});
    material_.name_ = text_value(root, "name", true);
    material_.description_ = text_value(root, "description", false);
    material_.source_ = text_value(root, "source", false);
    material_.license_ = text_value(root, "license", false);
    read_model(root);
    read_parameters(root);
    read_grid(root);
    return std::move(material_);
  }

 private:
  [[noreturn]] void fail(const toml::source_region& where, const std::string& what) const {
    throw PlacedFault("{}:{}:{}: {}", source_, std::max(where.begin.line, 1u),
                      std::max(where.begin.column, 1u), what);
  }

  [[noreturn]] void fail(std::string_view key, const toml::node& node, const std::string& what) const {
    fail(node.source(), fmt::format("{} = {}: {}", key, value_text(node), what));
  }

  void check_is_text() const {
    if (trimmed(material_.text_).empty())
      throw BadInput("{}:1:1: the file is empty; a material needs a name and [parameters]", source_);
    for (std::size_t line = 0; line < lines_.size(); ++line)
      for (std::size_t column = 0; column < lines_[line].size(); ++column)
        if (const auto c = static_cast<unsigned char>(lines_[line][column]);
            (c < 0x20 && c != '\t' && c != '\r') || c == 0x7f)
          throw BadInput("{}:{}:{}: byte 0x{:02x}: a material is a text file in TOML", source_, line + 1,
                         column + 1, c);
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      const auto text = trimmed(lines_[line]);
      const auto key = text.starts_with('[')
                           ? text
                           : text.substr(0, text.find('=') == std::string_view::npos ? 0 : text.find('='));
      if (std::count(key.begin(), key.end(), '.') > most_dots_of_a_key)
        throw BadInput("{}:{}:1: {}: a key has at most {} dots", source_, line + 1, excerpt(key),
                       most_dots_of_a_key);
    }
  }

  // The value as the file spells it.
  std::string value_text(const toml::node& node) const {
    const auto& region = node.source();
    if (region.begin.line == 0 || region.begin.line > lines_.size()) return std::string(type_name(node));
    const auto line = lines_[region.begin.line - 1];
    const std::size_t begin = byte_of_column(line, region.begin.column);
    const std::size_t end =
        region.end.line == region.begin.line ? byte_of_column(line, region.end.column) : line.size();
    return excerpt(trimmed(line.substr(begin, end - begin)));
  }

  void check_keys(const toml::table& table, std::string_view prefix,
                  const std::vector<std::string_view>& known) const {
    for (const auto& [key, node] : table) {
      const std::string_view name = key.str();
      if (std::find(known.begin(), known.end(), name) != known.end()) continue;
      const auto nearest = *std::min_element(known.begin(), known.end(), [&](auto a, auto b) {
        return edit_distance(name, a) < edit_distance(name, b);
      });
      const bool is_typo =
          edit_distance(name, nearest) <= std::max<std::size_t>(2, nearest.size() / 3) && nearest.size() > 2;
      fail(key.source(),
           fmt::format("{}{} = {}: unknown key{}; allowed: {}", prefix, excerpt(name), value_text(node),
                       is_typo ? fmt::format("; did you mean {}?", nearest) : "", joined(known)));
    }
  }

  std::string text_value(const toml::table& root, std::string_view key, bool required) const {
    const toml::node* node = root.get(key);
    if (!node) {
      if (required) fail(root.source(), fmt::format("{} is missing: a string is required", key));
      return {};
    }
    if (!node->is_string()) fail(key, *node, "must be a string");
    const std::string value = **node->as_string();
    const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
    if (std::any_of(value.begin(), value.end(), is_control))
      fail(key, *node, "must be one line without control characters");
    if (required && trimmed(value).empty()) fail(key, *node, "must not be empty");
    return value;
  }

  const toml::table* optional_table(const toml::table& root, std::string_view key) const {
    const toml::node* node = root.get(key);
    if (!node) return nullptr;
    if (!node->is_table()) fail(key, *node, "must be a table");
    return node->as_table();
  }

  double number(std::string_view key, const toml::node& node, const std::string& allowed) const {
    const auto value = node.is_number() ? node.value<double>() : std::nullopt;
    if (!value) fail(key, node, fmt::format("must be a number, {}, not {}", allowed, type_name(node)));
    if (!std::isfinite(*value)) fail(key, node, fmt::format("must be finite, {}", allowed));
    return *value;
  }

  double parameter(const ParameterRow& row, std::string_view prefix, const toml::node& node) const {
    const std::string key = fmt::format("{}{}", prefix, row.name);
    const std::string allowed = fmt::format("{} to {}", row.minimum, row.maximum);
    const double value = number(key, node, allowed);
    if (value < row.minimum || value > row.maximum) fail(key, node, fmt::format("must lie in {}", allowed));
    return value == 0 ? 0 : value;
  }

  static std::vector<std::string_view> parameter_names() {
    std::vector<std::string_view> names;
    for (const auto& row : parameter_table) names.push_back(row.name);
    return names;
  }

  void read_parameters(const toml::table& root) {
    const toml::table* table = optional_table(root, "parameters");
    if (!table)
      fail(root.source(), fmt::format("[parameters] is missing: it must give {}", joined(parameter_names())));
    check_keys(*table, "parameters.", parameter_names());
    Parameters parameters{};
    for (const auto& row : parameter_table) {
      const toml::node* node = table->get(row.name);
      if (!node)
        fail(table->source(), fmt::format("parameters.{} is missing: a number from {} to {} is required ({})",
                                          row.name, row.minimum, row.maximum, row.meaning));
      parameters.*row.member = parameter(row, "parameters.", *node);
    }
    read_bands(root, parameters);
  }

  void read_bands(const toml::table& root, const Parameters& parameters) {
    const toml::node* node = root.get("band");
    if (!node) {
      material_.bands_.push_back({std::nullopt, parameters});
      return;
    }
    const toml::array* bands = node->as_array();
    if (!bands || bands->empty() || !bands->is_array_of_tables())
      fail("band", *node, "must be one or more tables, each headed [[band]]");
    auto known = parameter_names();
    known.insert(known.begin(), "wavelength_nm");
    for (const auto& element : *bands) {
      const toml::table& table = *element.as_table();
      check_keys(table, "band.", known);
      const toml::node* wavelength = table.get("wavelength_nm");
      if (!wavelength)
        fail(table.source(), "band.wavelength_nm is missing: a number above 0, in nm, is required");
      const std::string allowed = "in nm, above 0 and at most 1e9";
      Band band{number("band.wavelength_nm", *wavelength, allowed), parameters};
      if (*band.wavelength_nm <= 0 || *band.wavelength_nm > 1e9)
        fail("band.wavelength_nm", *wavelength, fmt::format("must be {}", allowed));
      if (!material_.bands_.empty() && *band.wavelength_nm <= *material_.bands_.back().wavelength_nm)
        fail("band.wavelength_nm", *wavelength,
             fmt::format("must be above the band before it, {} nm", *material_.bands_.back().wavelength_nm));
      for (const auto& row : parameter_table)
        if (const toml::node* value = table.get(row.name))
          band.parameters.*row.member = parameter(row, "band.", *value);
      material_.bands_.push_back(band);
    }
  }

  void read_model(const toml::table& root) {
    const toml::table* table = optional_table(root, "model");
    if (!table) return;
    std::vector<std::string_view> names;
    for (const auto& row : variant_table()) names.push_back(row.name);
    check_keys(*table, "model.", names);
    for (const auto& row : variant_table()) {
      const toml::node* node = table->get(row.name);
      if (!node) continue;
      const std::string key = fmt::format("model.{}", row.name);
      const std::string wanted =
          fmt::format("must be {}{}", row.is_boolean() ? "" : "one of the strings ", joined(row.choices));
      std::string value;
      if (row.is_boolean() && node->is_boolean()) value = **node->as_boolean() ? "true" : "false";
      if (!row.is_boolean() && node->is_string()) value = **node->as_string();
      const auto choice = std::find(row.choices.begin(), row.choices.end(), value);
      if (choice == row.choices.end()) fail(key, *node, wanted);
      row.set(material_.variant_, static_cast<int>(choice - row.choices.begin()));
    }
    if (material_.variant_.normalization == Normalization::closed_form &&
        material_.variant_.autocovariance == Autocovariance::gaussian)
      fail("model.normalization", *table->get("normalization"),
           "Eq. (8) normalises a Lorentzian; a gaussian autocovariance takes hemispherical or reciprocal");
  }

  void read_grid(const toml::table& root) {
    const toml::table* table = optional_table(root, "grid");
    if (!table) return;
    std::vector<std::string_view> names;
    for (const auto& row : axis_table) names.push_back(row.name);
    check_keys(*table, "grid.", names);
    for (const auto& row : axis_table) {
      const toml::node* node = table->get(row.name);
      if (!node) continue;
      const std::string key = fmt::format("grid.{}", row.name);
      try {
        material_.grid_[row.kind] = axis(key, row.kind, *node);
      } catch (const PlacedFault&) {
        throw;
      } catch (const BadInput& error) {
        fail(key, *node, error.what());
      }
    }
  }

  Axis axis(const std::string& key, AxisKind kind, const toml::node& node) const {
    if (const auto* text = node.as_string()) return Axis::parse(kind, **text);
    const auto* array = node.as_array();
    if (!array) fail(key, node, "must be \"start:stop:step\" or an array of numbers, in degrees");
    std::vector<double> nodes;
    for (const auto& element : *array) nodes.push_back(number(key, element, "in degrees"));
    return Axis(kind, std::move(nodes));
  }

  std::string source_;
  Material material_;
  std::vector<std::string_view> lines_;
};

Material Material::at_wavelength(double wavelength_nm) const {
  if (!has_wavelengths())
    throw BadInput("{} has no bands, and so none at {} nm", name_, shortest(wavelength_nm));
  const auto band = std::find_if(bands_.begin(), bands_.end(),
                                 [&](const Band& b) { return b.wavelength_nm == wavelength_nm; });
  if (band == bands_.end()) {
    std::vector<std::string> known;
    for (const Band& b : bands_) known.push_back(shortest(*b.wavelength_nm));
    throw BadInput("{} has no band at {} nm; it has {}", name_, shortest(wavelength_nm),
                   fmt::join(known, ", "));
  }
  Material result = *this;
  result.bands_ = {*band};
  return result;
}

Material Material::parse(std::string text, const std::string& source) {
  return MaterialReader(std::move(text), source).read();
}

Material Material::read(const std::filesystem::path& file) {
  std::string text;
  const auto take = [&](std::istream& in) {
    text.resize(largest_material_bytes + 1);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
  };
  if (file == "-") {
    take(std::cin);
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
      throw FileError("{}: is a folder, not a material file", file.string());
    std::ifstream in(file, std::ios::binary);
    if (!in)
      throw FileError("{}: cannot be opened: {}", file.string(), std::generic_category().message(errno));
    take(in);
  }
  const std::string source = file == "-" ? "standard input" : file.string();
  if (text.size() > largest_material_bytes)
    throw BadInput("{}:1:1: is larger than {} bytes, the most that a material file may have", source,
                   largest_material_bytes);
  return parse(std::move(text), source);
}

}  // namespace brdftab

#include "host/model/material/toml_document.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

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

TomlDocument::TomlDocument(const std::string& text, std::string source) : source_(std::move(source)) {
  for (std::string_view rest = text;;) {
    const auto end = rest.find('\n');
    lines_.push_back(rest.substr(0, end));
    if (end == std::string_view::npos) break;
    rest.remove_prefix(end + 1);
  }
  check_is_text(text);
  try {
    root_ = toml::parse(std::string_view(text), std::string_view(source_));
  } catch (const toml::parse_error& error) {
    refuse(error.source(), std::string(error.description()));
  }
}

std::string TomlDocument::place(const toml::source_region& where) const {
  return fmt::format("{}:{}:{}", source_, std::max(where.begin.line, 1u), std::max(where.begin.column, 1u));
}

void TomlDocument::refuse(const toml::source_region& where, const std::string& what) const {
  throw BadInput("{}: {}", place(where), what);
}

void TomlDocument::refuse(std::string_view name, const toml::node& node, const std::string& allowed) const {
  throw BadInput::at(place(node.source()), {std::string(name), value_text(node)}, allowed);
}

void TomlDocument::check_is_text(const std::string& text) const {
  if (trimmed(text).empty())
    throw BadInput("{}:1:1: the file is empty; a material needs a name and [parameters]", source_);
  for (std::size_t line = 0; line < lines_.size(); ++line)
    for (std::size_t column = 0; column < lines_[line].size(); ++column)
      if (const auto c = static_cast<unsigned char>(lines_[line][column]);
          (c < 0x20 && c != '\t' && c != '\r') || c == 0x7f)
        throw BadInput("{}:{}:{}: byte 0x{:02x}: a material is a text file in TOML", source_, line + 1,
                       column + 1, c);
  for (std::size_t line = 0; line < lines_.size(); ++line) {
    const auto words = trimmed(lines_[line]);
    const auto equals = words.find('=');
    const auto key =
        words.starts_with('[') ? words : words.substr(0, equals == std::string_view::npos ? 0 : equals);
    if (std::count(key.begin(), key.end(), '.') > most_dots_of_a_key)
      throw BadInput("{}:{}:1: {}: a key has at most {} dots", source_, line + 1, excerpt(key),
                     most_dots_of_a_key);
  }
}

// The value as the file spells it.
std::string TomlDocument::value_text(const toml::node& node) const {
  const auto& region = node.source();
  if (region.begin.line == 0 || region.begin.line > lines_.size()) return std::string(type_name(node));
  const auto line = lines_[region.begin.line - 1];
  const std::size_t begin = byte_of_column(line, region.begin.column);
  const std::size_t end =
      region.end.line == region.begin.line ? byte_of_column(line, region.end.column) : line.size();
  return excerpt(trimmed(line.substr(begin, end - begin)));
}

void TomlDocument::check_keys(const toml::table& table, std::string_view prefix,
                              const std::vector<std::string_view>& known) const {
  for (const auto& [key, node] : table) {
    const std::string_view name = key.str();
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    const auto nearest = *std::min_element(known.begin(), known.end(), [&](auto a, auto b) {
      return edit_distance(name, a) < edit_distance(name, b);
    });
    const bool is_typo =
        edit_distance(name, nearest) <= std::max<std::size_t>(2, nearest.size() / 3) && nearest.size() > 2;
    refuse(key.source(),
           fmt::format("{}{} = {}: unknown key{}; allowed: {}", prefix, excerpt(name), value_text(node),
                       is_typo ? fmt::format("; did you mean {}?", nearest) : "", fmt::join(known, ", ")));
  }
}

std::string TomlDocument::text(const toml::table& table, std::string_view prefix,
                               std::string_view key) const {
  const toml::node* node = table.get(key);
  return node ? text(fmt::format("{}{}", prefix, key), *node) : std::string();
}

const toml::table* TomlDocument::optional_table(const toml::table& table, std::string_view prefix,
                                                std::string_view key) const {
  const toml::node* node = table.get(key);
  if (!node) return nullptr;
  if (!node->is_table()) refuse(fmt::format("{}{}", prefix, key), *node, "must be a table");
  return node->as_table();
}

std::string TomlDocument::text(std::string_view name, const toml::node& node) const {
  if (!node.is_string()) refuse(name, node, "must be a string");
  const std::string value = **node.as_string();
  const auto is_control = [](unsigned char c) { return c < 0x20 || c == 0x7f; };
  if (std::any_of(value.begin(), value.end(), is_control))
    refuse(name, node, "must be one line without control characters");
  return value;
}

double TomlDocument::number(std::string_view name, const toml::node& node, std::string_view allowed) const {
  const auto value = node.is_number() ? node.value<double>() : std::nullopt;
  if (!value) refuse(name, node, fmt::format("must be a number, {}, not {}", allowed, type_name(node)));
  if (!std::isfinite(*value)) refuse(name, node, fmt::format("must be finite, {}", allowed));
  return *value == 0 ? 0 : *value;
}

double TomlDocument::number(std::string_view name, const toml::node& node, double minimum,
                            double maximum) const {
  const std::string allowed = fmt::format("{} to {}", minimum, maximum);
  const double value = number(name, node, allowed);
  if (value < minimum || value > maximum) refuse(name, node, fmt::format("must lie in {}", allowed));
  return value;
}

std::size_t TomlDocument::count(std::string_view name, const toml::node& node) const {
  const auto value = node.is_integer() ? node.value<std::int64_t>() : std::nullopt;
  if (!value || *value < 0) refuse(name, node, "must be a whole number, 0 or above");
  return static_cast<std::size_t>(*value);
}

bool TomlDocument::boolean(std::string_view name, const toml::node& node) const {
  if (!node.is_boolean()) refuse(name, node, "must be true or false");
  return **node.as_boolean();
}

std::size_t TomlDocument::choice(std::string_view name, const toml::node& node,
                                 const std::vector<std::string_view>& choices) const {
  const bool is_boolean = choices.front() == "true";
  std::string value;
  if (is_boolean && node.is_boolean()) value = **node.as_boolean() ? "true" : "false";
  if (!is_boolean && node.is_string()) value = **node.as_string();
  const auto at = std::find(choices.begin(), choices.end(), value);
  if (at == choices.end())
    refuse(name, node,
           fmt::format("must be {}{}", is_boolean ? "" : "one of the strings ", fmt::join(choices, ", ")));
  return static_cast<std::size_t>(at - choices.begin());
}

const toml::array& TomlDocument::array(std::string_view name, const toml::node& node,
                                       const std::string& allowed) const {
  const auto* array = node.as_array();
  if (!array) refuse(name, node, allowed);
  return *array;
}

}  // namespace brdftab

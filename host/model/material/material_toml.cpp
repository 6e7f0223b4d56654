#include "host/model/material/material_toml.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <span>
#include <utility>

#include "host/base/numbers.hpp"
#include "host/model/variant.hpp"

namespace brdftab {
namespace {

bool is_utf8(std::string_view text) {
  std::size_t following = 0;  // bytes that a character still needs
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte >> 6 == 2) != (following > 0)) return false;
    if (byte >> 6 == 2)
      --following;
    else
      following = byte < 0x80 ? 0 : byte >> 5 == 6 ? 1 : byte >> 4 == 14 ? 2 : 3;
  }
  return following == 0;
}

// A basic string. A text that is not UTF-8 keeps what of it is ASCII.
std::string toml_string(std::string_view text) {
  const bool is_readable = is_utf8(text);
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    result += byte < 0x20 || byte == 0x7f ? ' ' : byte >= 0x80 && !is_readable ? '?' : c;
  }
  return result + '"';
}

// With a point, so that it is not taken for a count.
std::string decimal(double value) {
  const std::string text = shortest(value);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

std::string pair(const FitRange& range) {
  return fmt::format("[{}, {}]", decimal(range.low), decimal(range.high));
}

std::string list(const std::vector<std::string>& texts) {
  std::vector<std::string> words;
  for (const std::string& text : texts) words.push_back(toml_string(text));
  return fmt::format("[{}]", fmt::join(words, ", "));
}

// The value of a key of `[fit]`; empty where there is none.
std::string value_text(const std::string& text) { return text.empty() ? "" : toml_string(text); }
std::string value_text(bool is_so) { return is_so ? "true" : ""; }
std::string value_text(const std::optional<double>& number) { return number ? decimal(*number) : ""; }
std::string value_text(const std::optional<std::size_t>& count) {
  return count ? fmt::format("{}", *count) : "";
}
std::string value_text(const std::optional<FitRange>& range) { return range ? pair(*range) : ""; }
std::string value_text(const std::vector<std::string>& texts) { return texts.empty() ? "" : list(texts); }

std::string fitted_text(const FittedParameter& fitted) {
  std::string text;
  if (fitted.interval)
    text +=
        fmt::format("low = {}\nhigh = {}\n", decimal(fitted.interval->low), decimal(fitted.interval->high));
  if (fitted.open_below || fitted.open_above)
    text += fmt::format("open = \"{}\"\n", !fitted.open_above   ? "below"
                                           : !fitted.open_below ? "above"
                                                                : "both");
  if (fitted.at_bound) text += "at_bound = true\n";
  if (fitted.bounds) text += fmt::format("bounds = {}\n", pair(*fitted.bounds));
  return text;
}

std::string fitted_tables(const FittedParameters& fitted, std::string_view prefix) {
  std::string text;
  for (std::size_t p = 0; p < fitted.size(); ++p)
    if (fitted[p])
      text += fmt::format("\n[{}{}]\n{}", prefix, parameter_table[p].name, fitted_text(*fitted[p]));
  return text;
}

std::string incidence_text(const FittedIncidence& at) {
  return fmt::format("  {{ theta_i = {}, {}samples = {}, rms = {}, dhr = {} }},\n", decimal(at.theta_i),
                     at.settings ? fmt::format("settings = {}, ", pair(*at.settings)) : "", at.samples,
                     decimal(at.rms), decimal(at.dhr));
}

std::string fit_text(const FitRecord& fit) {
  std::string text = "\n[fit]\n";
  for (const FitKey& key : fit_keys()) {
    const std::string value = std::visit([&](auto member) { return value_text(fit.*member); }, key.member);
    if (!value.empty()) text += fmt::format("{} = {}\n", key.name, value);
  }
  if (!fit.incidences.empty()) {
    text += "incidences = [\n";
    for (const FittedIncidence& at : fit.incidences) text += incidence_text(at);
    text += "]\n";
  }
  return text + fitted_tables(fit.parameters, "fit.");
}

std::string parameter_line(const ParameterRow& row, const Parameters& parameters) {
  return fmt::format("{} = {}\n", row.name, shortest(parameters.*row.member));
}

std::string bands_text(const MaterialContent& material) {
  std::string text;
  const auto& bands = material.bands;
  for (std::size_t b = 0; b < bands.size() && bands[b].wavelength_nm; ++b) {
    text += fmt::format("\n[[band]]\nwavelength_nm = {}\n", decimal(*bands[b].wavelength_nm));
    for (std::size_t p = 0; p < parameter_table.size(); ++p) {
      const ParameterRow& row = parameter_table[p];
      const bool differs = std::any_of(bands.begin(), bands.end(), [&](const Band& band) {
        return band.parameters.*row.member != bands.front().parameters.*row.member;
      });
      if (differs || (material.fit && material.fit->bands[b][p]))
        text += parameter_line(row, bands[b].parameters);
    }
    if (material.fit) text += fitted_tables(material.fit->bands[b], "band.fit.");
  }
  return text;
}

std::string model_text(const Variant& variant) {
  std::string text;
  for (const VariantRow& row : variant_table()) {
    const auto choice = choice_name(row, variant);
    if (choice != row.choices.front())
      text +=
          fmt::format("{} = {}\n", row.name, row.is_boolean() ? std::string(choice) : toml_string(choice));
  }
  return text.empty() ? "" : "\n[model]\n" + text;
}

bool are_equal(std::span<const double> a, std::span<const double> b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end());
}

std::string grid_text(const Grid& grid) {
  std::string text;
  for (const auto& row : axis_table) {
    const auto nodes = grid[row.kind].nodes();
    if (are_equal(nodes, Axis::default_axis(row.kind).nodes())) continue;
    std::vector<std::string> words;
    for (const double node : nodes) words.push_back(shortest(node));
    text += fmt::format("{} = [{}]\n", row.name, fmt::join(words, ", "));
  }
  return text.empty() ? "" : "\n[grid]\n" + text;
}

}  // namespace

std::string material_toml(const MaterialContent& material) {
  std::string text = fmt::format("name = {}\n", toml_string(material.name));
  for (const auto& [key, value] : {std::pair{"description", &material.description},
                                   {"source", &material.source},
                                   {"license", &material.license}})
    if (!value->empty()) text += fmt::format("{} = {}\n", key, toml_string(*value));
  text += "\n[parameters]\n";
  for (const ParameterRow& row : parameter_table)
    text += parameter_line(row, material.bands.front().parameters);
  text += model_text(material.variant);
  text += bands_text(material);
  if (material.fit) text += fit_text(*material.fit);
  return text + grid_text(material.grid);
}

}  // namespace brdftab

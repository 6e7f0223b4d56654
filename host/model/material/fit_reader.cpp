#include "host/model/material/fit_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace brdftab {
namespace {

constexpr double anything = 1e300;

class FitReader {
 public:
  FitReader(const TomlDocument& toml) : toml_(toml) {}

  /// A key of `[fit]`.
  void read(FitRecord& record, const FitKey& key, const toml::node& node) const {
    const std::string name = fmt::format("fit.{}", key.name);
    std::visit([&](auto member) { read(record.*member, key, name, node); }, key.member);
  }

  FittedParameters parameters(const toml::table& fit, std::string_view prefix) const {
    FittedParameters result;
    for (std::size_t p = 0; p < parameter_table.size(); ++p)
      if (const toml::table* table = toml_.optional_table(fit, prefix, parameter_table[p].name))
        result[p] = parameter(*table, parameter_table[p], prefix);
    return result;
  }

  std::vector<FittedIncidence> incidences(const toml::node& node) const {
    std::vector<FittedIncidence> result;
    const std::string allowed = "must be an array of tables, { theta_i = …, samples = …, rms = …, dhr = … }";
    for (const auto& element : toml_.array("fit.incidences", node, allowed)) {
      const toml::table* table = element.as_table();
      if (!table) toml_.refuse("fit.incidences", element, allowed);
      toml_.check_keys(*table, prefix_of_incidences, {"theta_i", "settings", "samples", "rms", "dhr"});
      FittedIncidence at{
          .theta_i = toml_.number("fit.incidences.theta_i", required(*table, "theta_i"), 0, 90),
          .settings = {},
          .samples = toml_.count("fit.incidences.samples", required(*table, "samples")),
          .rms = toml_.number("fit.incidences.rms", required(*table, "rms"), 0, anything),
          .dhr = toml_.number("fit.incidences.dhr", required(*table, "dhr"), 0, anything)};
      if (const toml::node* settings = table->get("settings"))
        at.settings = range("fit.incidences.settings", *settings, 0, 90);
      result.push_back(at);
    }
    return result;
  }

 private:
  static constexpr std::string_view prefix_of_incidences = "fit.incidences.";

  const toml::node& required(const toml::table& table, std::string_view key) const {
    const toml::node* node = table.get(key);
    if (!node)
      toml_.refuse(table.source(),
                   fmt::format("{}{} is missing: a number is required", prefix_of_incidences, key));
    return *node;
  }

  void read(std::string& value, const FitKey& key, const std::string& name, const toml::node& node) const {
    value = key.choices.empty() ? toml_.text(name, node)
                                : std::string(key.choices[toml_.choice(name, node, key.choices)]);
  }

  void read(bool& value, const FitKey&, const std::string& name, const toml::node& node) const {
    value = toml_.boolean(name, node);
  }

  void read(std::optional<double>& value, const FitKey& key, const std::string& name,
            const toml::node& node) const {
    value = toml_.number(name, node, key.minimum, key.maximum);
  }

  void read(std::optional<std::size_t>& value, const FitKey&, const std::string& name,
            const toml::node& node) const {
    value = toml_.count(name, node);
  }

  void read(std::optional<FitRange>& value, const FitKey& key, const std::string& name,
            const toml::node& node) const {
    value = range(name, node, key.minimum, key.maximum);
  }

  void read(std::vector<std::string>& list, const FitKey& key, const std::string& name,
            const toml::node& node) const {
    for (const auto& element : toml_.array(name, node, "must be an array of strings"))
      read(list.emplace_back(), key, name, element);
  }

  FitRange range(const std::string& name, const toml::node& node, double minimum, double maximum) const {
    const std::string allowed = "must be an array of two numbers, the lower one first";
    const toml::array& ends = toml_.array(name, node, allowed);
    if (ends.size() != 2) toml_.refuse(name, node, allowed);
    const FitRange result{toml_.number(name, *ends.get(0), minimum, maximum),
                          toml_.number(name, *ends.get(1), minimum, maximum)};
    if (result.low > result.high) toml_.refuse(name, node, allowed);
    return result;
  }

  FittedParameter parameter(const toml::table& table, const ParameterRow& row,
                            std::string_view prefix) const {
    const std::string path = fmt::format("{}{}.", prefix, row.name);
    toml_.check_keys(table, path, {"low", "high", "open", "at_bound", "bounds"});
    FittedParameter result;
    const toml::node *low = table.get("low"), *high = table.get("high");
    if (!low != !high)
      toml_.refuse(table.source(),
                   fmt::format("{}{} is missing: an interval has low and high", path, low ? "high" : "low"));
    if (low) {
      result.interval = {toml_.number(path + "low", *low, row.minimum, row.maximum),
                         toml_.number(path + "high", *high, row.minimum, row.maximum)};
      if (result.interval->low > result.interval->high)
        toml_.refuse(path + "high", *high, "must not be below low");
    }
    if (const toml::node* open = table.get("open")) {
      const std::size_t side = toml_.choice(path + "open", *open, {"below", "above", "both"});
      result.open_below = side != 1;
      result.open_above = side != 0;
    }
    if (const toml::node* at_bound = table.get("at_bound"))
      result.at_bound = toml_.boolean(path + "at_bound", *at_bound);
    if (const toml::node* bounds = table.get("bounds"))
      result.bounds = range(path + "bounds", *bounds, row.minimum, row.maximum);
    return result;
  }

  const TomlDocument& toml_;
};

}  // namespace

std::optional<FitRecord> read_fit(const TomlDocument& toml, std::size_t bands) {
  const FitReader reader(toml);
  FitRecord record;
  record.bands.resize(bands);
  bool is_fitted = false;
  if (const toml::table* fit = toml.optional_table(toml.root(), "", "fit")) {
    is_fitted = true;
    auto known = parameter_names();
    for (const FitKey& key : fit_keys()) known.push_back(key.name);
    known.push_back("incidences");
    toml.check_keys(*fit, "fit.", known);
    for (const FitKey& key : fit_keys())
      if (const toml::node* node = fit->get(key.name)) reader.read(record, key, *node);
    if (const toml::node* node = fit->get("incidences")) record.incidences = reader.incidences(*node);
    record.parameters = reader.parameters(*fit, "fit.");
  }
  const toml::array* list = toml.root()["band"].as_array();
  for (std::size_t b = 0; list && b < list->size(); ++b)
    if (const toml::table* fit = toml.optional_table(*list->get(b)->as_table(), "band.", "fit")) {
      is_fitted = true;
      toml.check_keys(*fit, "band.fit.", parameter_names());
      record.bands[b] = reader.parameters(*fit, "band.fit.");
    }
  return is_fitted ? std::optional(std::move(record)) : std::nullopt;
}

}  // namespace brdftab

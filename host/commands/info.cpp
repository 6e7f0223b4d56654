#include <nlohmann/json.hpp>

#include <algorithm>

#include "host/base/numbers.hpp"
#include "host/commands/command.hpp"
#include "host/formats/open_table.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {
namespace {

std::string axis_text(const VariableInfo& axis) {
  const auto& nodes = axis.values;
  if (nodes.empty()) return "no nodes";
  if (nodes.size() == 1) return fmt::format("1 node: {} {}", shortest(nodes[0]), axis.units);
  double smallest = nodes[1] - nodes[0];
  double largest = smallest;
  for (std::size_t k = 1; k < nodes.size(); ++k) {
    smallest = std::min(smallest, nodes[k] - nodes[k - 1]);
    largest = std::max(largest, nodes[k] - nodes[k - 1]);
  }
  const std::string step = largest - smallest <= 1e-9 * largest
                               ? fmt::format("by {:.10g}", largest)
                               : fmt::format("by {:.4g} to {:.4g}", smallest, largest);
  return fmt::format("{} nodes: {} to {} {} {}", nodes.size(), shortest(nodes.front()),
                     shortest(nodes.back()), axis.units, step);
}

std::string range_text(const VariableInfo& variable) {
  if (variable.values.empty()) return {};
  const auto [low, high] = std::minmax_element(variable.values.begin(), variable.values.end());
  return fmt::format(", {:.6g} to {:.6g}", *low, *high);
}

void print_text(const std::string& name, const TableInfo& info) {
  fmt::print("{}\n", name);
  fmt::print("\naxes\n");
  for (const auto& variable : info.variables)
    if (variable.is_axis) fmt::print("  {:<12} {}\n", variable.name, axis_text(variable));
  fmt::print("\nvariables\n");
  for (const auto& variable : info.variables)
    if (!variable.is_axis) {
      fmt::print("  {:<22} {}[{}] {}  {}{}\n", variable.name, variable.type,
                 fmt::join(variable.dimensions, ", "), variable.units, variable.long_name,
                 range_text(variable));
      if (variable.values.empty() && variable.storage)
        fmt::print("  {:<22} {}\n", "", variable.storage->text());
    }
  fmt::print("\nattributes\n");
  for (const auto& attribute : info.attributes) {
    if (const auto* text = std::get_if<std::string>(&attribute.value)) {
      if (attribute.name == "material") continue;
      fmt::print("  {:<39} {}\n", attribute.name, *text);
    } else if (const auto* number = std::get_if<double>(&attribute.value)) {
      fmt::print("  {:<39} {}\n", attribute.name, shortest(*number));
    } else {
      fmt::print("  {:<39} {}\n", attribute.name,
                 fmt::join(std::get<std::vector<double>>(attribute.value), ", "));
    }
  }
  for (const auto& attribute : info.attributes)
    if (attribute.name == "material")
      fmt::print("\nmaterial\n\n{}\n", std::get<std::string>(attribute.value));
}

nlohmann::ordered_json storage_json(const StorageInfo& storage) {
  nlohmann::ordered_json entry{{"layout", storage.layout}};
  if (!storage.chunk.empty()) entry["chunk"] = storage.chunk;
  if (!storage.filters.empty()) entry["filters"] = storage.filters;
  if (!storage.view_of.empty()) entry["view_of"] = storage.view_of;
  entry["bytes"] = storage.bytes;
  if (storage.ratio > 0) entry["ratio"] = storage.ratio;
  return entry;
}

nlohmann::ordered_json as_json(const TableInfo& info) {
  nlohmann::ordered_json root;
  for (const auto& attribute : info.attributes)
    std::visit([&](const auto& value) { root["attributes"][attribute.name] = value; }, attribute.value);
  for (const auto& variable : info.variables) {
    nlohmann::ordered_json entry{{"type", variable.type},           {"dimensions", variable.dimensions},
                                 {"shape", variable.shape},         {"units", variable.units},
                                 {"long_name", variable.long_name}, {"axis", variable.is_axis}};
    if (!variable.values.empty()) entry["values"] = variable.values;
    if (!variable.is_axis && variable.storage) entry["storage"] = storage_json(*variable.storage);
    root["variables"][variable.name] = entry;
  }
  return root;
}

}  // namespace

std::function<ExitStatus()> info_command(CLI::App& parser, const CommonOptions&) {
  struct Options {
    std::string table;
    bool json = false;
  };
  auto options = std::make_shared<Options>();
  parser.add_option("TABLE", options->table, "Table file, or the folder of an OpenEXR table in files")
      ->required();
  parser.add_flag("--json", options->json, "As JSON, with the values of axes, N and DHR");
  return [options] {
    const auto table = open_table(options->table);
    const TableInfo& info = table->info();
    if (options->json)
      fmt::print("{}\n", as_json(info).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    else
      print_text(options->table, info);
    return ExitStatus::done;
  };
}

}  // namespace brdftab

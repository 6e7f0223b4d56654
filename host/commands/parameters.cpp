#include "host/commands/command.hpp"
#include "host/model/axis.hpp"
#include "host/model/variant.hpp"

namespace brdftab {

std::function<ExitStatus()> parameters_command(CLI::App&, const CommonOptions&) {
  return [] {
    fmt::print("[parameters], all required\n");
    for (const auto& row : parameter_table)
      fmt::print("  {:<14} {:<10} {:<18} {:<17} {}\n", row.name, row.symbol,
                 fmt::format("{} to {}", row.minimum, row.maximum), row.unit == "1" ? "" : row.unit,
                 row.meaning);
    fmt::print("\n[model], optional; the first choice is the default\n");
    for (const auto& row : variant_table())
      fmt::print("  {:<22} {:<40} {}\n", row.name, fmt::format("{}", fmt::join(row.choices, ", ")),
                 row.meaning);
    fmt::print("\n[grid], optional; degrees, start:stop:step or an array\n");
    for (const auto& row : axis_table)
      fmt::print("  {:<8} default {:<8} {:<37} {}\n", row.name, row.default_text, row.range(), row.long_name);
    return ExitStatus::done;
  };
}

}  // namespace brdftab

#include "host/direction_list.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/error.hpp"
#include "host/interrupt.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto comma = line.find(',');
    cells.push_back(trimmed(line.substr(0, comma)));
    if (comma == std::string_view::npos) return cells;
    line.remove_prefix(comma + 1);
  }
}

struct Columns {
  std::optional<std::size_t> theta_i, theta_s, phi, phi_s, phi_i;
  std::size_t count;
};

Columns read_header(const std::vector<std::string_view>& cells, const std::string& where) {
  const auto column = [&](std::string_view name) -> std::optional<std::size_t> {
    const auto at = std::find(cells.begin(), cells.end(), name);
    if (at == cells.end()) return std::nullopt;
    if (std::count(cells.begin(), cells.end(), name) > 1) throw BadInput("{}: the column {} appears twice", where, name);
    return static_cast<std::size_t>(at - cells.begin());
  };
  const Columns columns{column("theta_i_deg"), column("theta_s_deg"), column("phi_deg"),
                        column("phi_s_deg"),   column("phi_i_deg"),   cells.size()};
  for (const auto& [present, name] : {std::pair{columns.theta_i, "theta_i_deg"}, {columns.theta_s, "theta_s_deg"}})
    if (!present)
      throw BadInput("{}: the column {} is missing; a header names theta_i_deg, theta_s_deg and phi_deg", where, name);
  if (!columns.phi && !columns.phi_s)
    throw BadInput("{}: the column phi_deg (or phi_s_deg) is missing; a header names theta_i_deg, theta_s_deg and phi_deg",
                   where);
  return columns;
}

double angle(std::string_view cell, std::string_view column, double minimum, double maximum, bool closed,
             const std::string& where) {
  const auto value = parse_number(cell);
  const bool in_range = value && *value >= minimum && *value <= maximum && (closed || (*value > minimum && *value < maximum));
  if (!in_range)
    throw BadInput("{}: {} = {}: must be a number {} {} {} {} degrees", where, column, excerpt(cell),
                   closed ? "from" : "strictly between", minimum, closed ? "to" : "and", maximum);
  return *value == 0 ? 0 : *value;
}

}  // namespace

std::vector<DirectionPair> read_directions(std::istream& in, const std::string& source) {
  std::vector<DirectionPair> pairs;
  std::optional<Columns> columns;
  std::string text;
  std::size_t line = 0;
  while (std::getline(in, text)) {
    ++line;
    std::string_view content = text;
    if (line == 1 && content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
    if (trimmed(content).empty() || trimmed(content).starts_with('#')) continue;
    const std::string where = fmt::format("{}:{}", source, line);
    const auto cells = cells_of(content);
    if (!columns) {
      columns = read_header(cells, where);
      continue;
    }
    if (cells.size() != columns->count)
      throw BadInput("{}: has {} cells where the header has {}", where, cells.size(), columns->count);
    const auto cell = [&](std::optional<std::size_t> k) { return cells[*k]; };
    DirectionPair pair{.theta_i = 0, .theta_s = 0, .phi = 0, .line = line};
    // theta_i is [0, 90); -0 has become 0.
    pair.theta_i = angle(cell(columns->theta_i), "theta_i_deg", -90, 90, false, where);
    if (pair.theta_i < 0)
      throw BadInput("{}: theta_i_deg = {}: must be a number from 0 to below 90 degrees", where, excerpt(cell(columns->theta_i)));
    pair.theta_s = angle(cell(columns->theta_s), "theta_s_deg", -90, 90, false, where);
    if (columns->phi) {
      pair.phi = angle(cell(columns->phi), "phi_deg", -360, 360, true, where);
    } else {
      pair.phi = angle(cell(columns->phi_s), "phi_s_deg", -360, 360, true, where);
      if (columns->phi_i) pair.phi -= angle(cell(columns->phi_i), "phi_i_deg", -360, 360, true, where);
    }
    pairs.push_back(pair);
  }
  stop_if_interrupted();
  if (!columns) throw BadInput("{}:1: is empty; a header must name theta_i_deg, theta_s_deg and phi_deg", source);
  return pairs;
}

}  // namespace brdftab

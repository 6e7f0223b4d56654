#include "host/model/direction_list.hpp"

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::string_view wanted = "theta_i_deg, theta_s_deg and phi_deg";

double angle(std::string_view cell, std::string_view column, double minimum, double maximum, bool closed,
             const std::string& where) {
  const auto value = parse_number(cell);
  const bool in_range =
      value && *value >= minimum && *value <= maximum && (closed || (*value > minimum && *value < maximum));
  if (!in_range)
    throw BadInput("{}: {} = {}: must be a number {} {} {} {} degrees", where, column, excerpt(cell),
                   closed ? "from" : "strictly between", minimum, closed ? "to" : "and", maximum);
  return *value == 0 ? 0 : *value;
}

}  // namespace

DirectionColumns::DirectionColumns(const Csv& csv)
    : theta_i_(csv.column("theta_i_deg")),
      theta_s_(csv.column("theta_s_deg")),
      phi_(csv.column("phi_deg")),
      phi_s_(csv.column("phi_s_deg")),
      phi_i_(csv.column("phi_i_deg")) {
  for (const auto& [present, name] : {std::pair{theta_i_, "theta_i_deg"}, {theta_s_, "theta_s_deg"}})
    if (!present)
      throw BadInput("{}: the column {} is missing; a header names {}", csv.where(), name, wanted);
  if (!phi_ && !phi_s_)
    throw BadInput("{}: the column phi_deg (or phi_s_deg) is missing; a header names {}", csv.where(),
                   wanted);
}

DirectionPair DirectionColumns::read(const Csv& csv, const std::vector<std::string_view>& cells) const {
  const std::string where = csv.where();
  DirectionPair pair{.theta_i = 0, .theta_s = 0, .phi = 0, .line = csv.line()};
  // theta_i is [0, 90); -0 has become 0.
  pair.theta_i = angle(cells[*theta_i_], "theta_i_deg", -90, 90, false, where);
  if (pair.theta_i < 0)
    throw BadInput("{}: theta_i_deg = {}: must be a number from 0 to below 90 degrees", where,
                   excerpt(cells[*theta_i_]));
  pair.theta_s = angle(cells[*theta_s_], "theta_s_deg", -90, 90, false, where);
  if (phi_) {
    pair.phi = angle(cells[*phi_], "phi_deg", -360, 360, true, where);
  } else {
    pair.phi = angle(cells[*phi_s_], "phi_s_deg", -360, 360, true, where);
    if (phi_i_) pair.phi -= angle(cells[*phi_i_], "phi_i_deg", -360, 360, true, where);
  }
  return pair;
}

std::vector<DirectionPair> read_directions(std::istream& in, const std::string& source) {
  Csv csv(in, source, wanted);
  const DirectionColumns columns(csv);
  std::vector<DirectionPair> pairs;
  while (const auto* cells = csv.next()) pairs.push_back(columns.read(csv, *cells));
  return pairs;
}

}  // namespace brdftab

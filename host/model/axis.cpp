#include "host/model/axis.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {

std::string AxisRow::range() const {
  return fmt::format("{} to {} degrees{}", minimum, maximum, includes_maximum ? "" : ", the end excluded");
}

const AxisRow& axis_row(AxisKind kind) { return axis_table[static_cast<std::size_t>(kind)]; }

Axis::Axis(AxisKind kind, std::vector<double> nodes) : kind_(kind), nodes_(std::move(nodes)) {
  const AxisRow& row = axis_row(kind);
  if (nodes_.empty()) throw BadInput("{} has no node: give at least one angle", row.name);
  if (nodes_.size() > longest_axis)
    throw BadInput("{} has {} nodes: at most {} are allowed", row.name, nodes_.size(), longest_axis);
  for (std::size_t k = 0; k < nodes_.size(); ++k) {
    const double angle = nodes_[k];
    const bool in_range =
        angle >= row.minimum && (row.includes_maximum ? angle <= row.maximum : angle < row.maximum);
    if (!in_range) throw BadInput("{} must lie in {}; {} does not", row.name, row.range(), shortest(angle));
    if (k > 0 && !(angle > nodes_[k - 1]))
      throw BadInput("{} must increase strictly; {} follows {}", row.name, shortest(angle),
                     shortest(nodes_[k - 1]));
    if (angle == 0) nodes_[k] = 0;  // no -0 in a file
  }
  if (nodes_.back() - nodes_.front() > 360)
    throw BadInput("{} must span at most 360 degrees; {} to {} is more", row.name, shortest(nodes_.front()),
                   shortest(nodes_.back()));
}

namespace {

std::vector<std::string_view> split(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  while (true) {
    const auto at = text.find(separator);
    parts.push_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

constexpr std::string_view axis_forms = "give start:stop:step, or angles separated by commas";

// Steps in long double, so that 0:1:0.1 has the doubles nearest to 0.1, 0.2, 0.3 ...
std::vector<double> range_nodes(std::string_view name, std::string_view text) {
  const auto parts = split(text, ':');
  std::optional<long double> number[3];
  for (std::size_t k = 0; k < 3; ++k) {
    number[k] = parts.size() == 3 ? parse_long_number(parts[k]) : std::nullopt;
    if (!number[k] || !std::isfinite(*number[k])) throw BadInput("{}: {}", name, axis_forms);
  }
  const auto [start, stop, step] = std::tuple(*number[0], *number[1], *number[2]);
  if (!(step > 0)) throw BadInput("{}: the step must be above 0", name);
  if (stop < start) throw BadInput("{} must increase strictly; the stop is below the start", name);
  const long double steps = (stop - start) / step;
  if (steps > longest_axis)
    throw BadInput("{} has {:.0f} nodes: at most {} are allowed", name, static_cast<double>(steps) + 1,
                   longest_axis);
  const auto count = static_cast<std::size_t>(std::llround(steps));
  if (std::abs(steps - static_cast<long double>(count)) > 1e-9L)
    throw BadInput("{}: the stop is not a whole number of steps from the start (both ends are nodes)", name);
  std::vector<double> nodes(count + 1);
  for (std::size_t k = 0; k <= count; ++k)
    nodes[k] = static_cast<double>(start + static_cast<long double>(k) * step);
  nodes.back() = static_cast<double>(stop);
  return nodes;
}

}  // namespace

Axis Axis::parse(AxisKind kind, std::string_view text) {
  const auto name = axis_row(kind).name;
  if (trimmed(text).empty()) return Axis(kind, {});
  if (text.find(':') != std::string_view::npos) return Axis(kind, range_nodes(name, text));
  std::vector<double> nodes;
  for (const auto part : split(text, ',')) {
    const auto number = parse_number(part);
    if (!number) throw BadInput("{}: '{}' is not a number; {}", name, excerpt(trimmed(part)), axis_forms);
    nodes.push_back(*number);
  }
  return Axis(kind, std::move(nodes));
}

Axis& Grid::operator[](AxisKind kind) {
  switch (kind) {
    case AxisKind::theta_i:
      return theta_i;
    case AxisKind::phi_i:
      return phi_i;
    case AxisKind::theta_s:
      return theta_s;
    default:
      return phi_s;
  }
}

}  // namespace brdftab

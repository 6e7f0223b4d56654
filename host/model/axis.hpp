// An axis of a table: angles in degrees that increase strictly.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brdftab {

enum class AxisKind { theta_i, phi_i, theta_s, phi_s };

struct AxisRow {
  AxisKind kind;
  std::string_view name;
  std::string_view long_name;
  double minimum;
  double maximum;
  bool includes_maximum;
  std::string_view default_text;

  /// The range in words, as messages and documentation give it.
  std::string range() const;
};

/// In the order of a table's dimensions.
inline constexpr AxisRow axis_table[] = {
    {AxisKind::theta_i, "theta_i", "polar angle of incidence", 0, 90, false, "0:85:5"},
    {AxisKind::phi_i, "phi_i", "azimuth of incidence (of the direction in which the light travels)", -360,
     360, true, "0"},
    {AxisKind::theta_s, "theta_s", "polar angle of scatter", 0, 90, false, "0:89:1"},
    {AxisKind::phi_s, "phi_s", "azimuth of scatter", -360, 360, true, "0:360:2"},
};

const AxisRow& axis_row(AxisKind kind);

inline constexpr std::size_t longest_axis = 100'000;

/// Nodes in degrees, valid by construction.
class Axis {
 public:
  /// Throws BadInput, which says what is wrong and what is allowed, but not where.
  Axis(AxisKind kind, std::vector<double> nodes);

  /// `start:stop:step` with both ends included, or numbers separated by commas.
  static Axis parse(AxisKind kind, std::string_view text);
  static Axis default_axis(AxisKind kind) { return parse(kind, axis_row(kind).default_text); }

  const AxisRow& row() const { return axis_row(kind_); }
  std::span<const double> nodes() const { return nodes_; }
  std::size_t size() const { return nodes_.size(); }
  double operator[](std::size_t k) const { return nodes_[k]; }

 private:
  AxisKind kind_;
  std::vector<double> nodes_;
};

/// The four angles of a table.
struct Grid {
  Axis theta_i = Axis::default_axis(AxisKind::theta_i);
  Axis phi_i = Axis::default_axis(AxisKind::phi_i);
  Axis theta_s = Axis::default_axis(AxisKind::theta_s);
  Axis phi_s = Axis::default_axis(AxisKind::phi_s);

  Axis& operator[](AxisKind kind);
  const Axis& operator[](AxisKind kind) const { return const_cast<Grid&>(*this)[kind]; }
  std::size_t directions() const { return theta_i.size() * phi_i.size() * theta_s.size() * phi_s.size(); }
};

}  // namespace brdftab

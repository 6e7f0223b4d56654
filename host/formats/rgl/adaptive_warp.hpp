// RGL files are interpolated by densities on the unit square and the warps that they define, as Mitsuba 3
// (Marginal2D), pbrt-v4 (PiecewiseLinear2D) and powitacq evaluate them. Source: Dupuy and Jakob, "An adaptive
// parameterization for efficient material acquisition and rendering", ACM Trans. Graph. 37 (2018).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace brdftab {

/// In a point of the unit square x runs along columns (theta), y along rows (phi).
struct SquarePoint {
  double x, y;
};

/// A value lies between two nodes of an increasing axis, with a weight of the one above. The end nodes serve
/// beyond the ends.
struct AxisPlace {
  AxisPlace(std::span<const float> axis, double value);
  AxisPlace(std::size_t node) : lower(node), upper(node), weight(0) {}

  double mix(double at_lower, double at_upper) const { return at_lower + weight * (at_upper - at_lower); }

  std::size_t lower, upper;
  double weight;
};

/// This is a view of values at the nodes of a stack of unit squares, bilinear between. Nodes lie at k / (n -
/// 1), both ends included.
class SquareTable {
 public:
  /// `values` is [square][row][column], with at least two rows and columns.
  SquareTable(std::span<const float> values, std::size_t rows, std::size_t columns);

  double at(std::size_t square, SquarePoint point) const;
  double at(const AxisPlace& square, SquarePoint point) const {
    return square.mix(at(square.lower, point), square.weight > 0 ? at(square.upper, point) : 0);
  }

 private:
  std::span<const float> values_;
  std::size_t rows_, columns_;
};

/// The warp maps the unit square to itself so that a uniform density becomes a table's, for each of a stack
/// of tables and between neighbours. It takes the marginal over rows, then the conditional over columns, both
/// piecewise quadratic.
class AdaptiveWarp {
 public:
  /// `densities` is [square][row][column]. Each is 0 or more, and no square is all 0; the scale does not
  /// matter, since each square is normalised.
  AdaptiveWarp(std::span<const float> densities, std::size_t rows, std::size_t columns);

  struct Warped {
    SquarePoint point;
    double density;  // of the warped point
  };
  /// Warps a uniform point to one of this density.
  Warped sample(const AxisPlace& square, SquarePoint uniform) const;
  /// Does the inverse; the density is that at the argument.
  Warped invert(const AxisPlace& square, SquarePoint warped) const;
  double density(const AxisPlace& square, SquarePoint point) const;

 private:
  double value(const AxisPlace& square, std::size_t row, std::size_t column) const;
  /// Integrates the row's density up to a column.
  double row_integral(const AxisPlace& square, std::size_t row, std::size_t column) const;
  /// Integrates the rows' integrals up to a row.
  double integral(const AxisPlace& square, std::size_t row) const;

  std::size_t rows_, columns_;
  std::vector<double> values_, row_integrals_, integrals_;
};

}  // namespace brdftab

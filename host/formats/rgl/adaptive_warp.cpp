#include "host/formats/rgl/adaptive_warp.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab {
namespace {

/// A coordinate of the unit square lies so far beyond a node, in steps.
struct Cell {
  Cell(double coordinate, std::size_t nodes) {
    const double steps = std::clamp(coordinate, 0.0, 1.0) * static_cast<double>(nodes - 1);
    node = std::min(static_cast<std::size_t>(steps), nodes - 2);
    rest = steps - static_cast<double>(node);
  }

  std::size_t node;
  double rest;
};

/// Says where, from 0 to 1, the integral of a linear density from v0 to v1 reaches `area`.
double inverse_of_linear(double area, double v0, double v1) {
  const double root = std::sqrt(std::max(v0 * v0 + 2 * area * (v1 - v0), 0.0));
  const double sum = v0 + root;
  return sum > 0 ? std::min(2 * area / sum, 1.0) : 0.0;
}

double integral_of_linear(double x, double v0, double v1) { return x * (v0 + 0.5 * x * (v1 - v0)); }

/// Finds the last node, but one at most, whose cumulative value does not exceed `value`.
template <class Cumulative>
std::size_t node_below(std::size_t nodes, double value, const Cumulative& cumulative) {
  std::size_t first = 0, last = nodes - 1;
  while (last - first > 1) {
    const std::size_t middle = first + (last - first) / 2;
    (cumulative(middle) <= value ? first : last) = middle;
  }
  return first;
}

}  // namespace

AxisPlace::AxisPlace(std::span<const float> axis, double value) {
  const auto above =
      static_cast<std::size_t>(std::upper_bound(axis.begin(), axis.end(), value) - axis.begin());
  lower = above == 0 ? 0 : above - 1;
  upper = std::min(above, axis.size() - 1);
  weight = lower == upper ? 0 : (value - axis[lower]) / (static_cast<double>(axis[upper]) - axis[lower]);
}

SquareTable::SquareTable(std::span<const float> values, std::size_t rows, std::size_t columns)
    : values_(values), rows_(rows), columns_(columns) {}

double SquareTable::at(std::size_t square, SquarePoint point) const {
  const Cell row(point.y, rows_), column(point.x, columns_);
  const float* v = &values_[(square * rows_ + row.node) * columns_ + column.node];
  const double below = v[0] + column.rest * (static_cast<double>(v[1]) - v[0]);
  const double above = v[columns_] + column.rest * (static_cast<double>(v[columns_ + 1]) - v[columns_]);
  return below + row.rest * (above - below);
}

AdaptiveWarp::AdaptiveWarp(std::span<const float> densities, std::size_t rows, std::size_t columns)
    : rows_(rows), columns_(columns), values_(densities.begin(), densities.end()) {
  const std::size_t squares = values_.size() / (rows * columns);
  row_integrals_.resize(values_.size());
  integrals_.resize(squares * rows);
  const double row_step = 1 / static_cast<double>(rows - 1),
               column_step = 1 / static_cast<double>(columns - 1);
  for (std::size_t square = 0; square < squares; ++square) {
    const std::size_t first_row = square * rows, end = first_row + rows;
    for (std::size_t row = first_row; row < end; ++row) {
      const double* value = &values_[row * columns];
      double* integral = &row_integrals_[row * columns];
      for (std::size_t column = 1; column < columns; ++column)
        integral[column] = integral[column - 1] + 0.5 * column_step * (value[column - 1] + value[column]);
    }
    const auto whole_row = [&](std::size_t row) { return row_integrals_[(row + 1) * columns - 1]; };
    for (std::size_t row = first_row + 1; row < end; ++row)
      integrals_[row] = integrals_[row - 1] + 0.5 * row_step * (whole_row(row - 1) + whole_row(row));
    const double total = integrals_[end - 1];
    for (std::size_t row = first_row; row < end; ++row) integrals_[row] /= total;
    for (std::size_t k = first_row * columns; k < end * columns; ++k) {
      values_[k] /= total;
      row_integrals_[k] /= total;
    }
  }
}

double AdaptiveWarp::value(const AxisPlace& square, std::size_t row, std::size_t column) const {
  const auto at = [&](std::size_t k) { return values_[(k * rows_ + row) * columns_ + column]; };
  return square.mix(at(square.lower), at(square.upper));
}

double AdaptiveWarp::row_integral(const AxisPlace& square, std::size_t row, std::size_t column) const {
  const auto at = [&](std::size_t k) { return row_integrals_[(k * rows_ + row) * columns_ + column]; };
  return square.mix(at(square.lower), at(square.upper));
}

double AdaptiveWarp::integral(const AxisPlace& square, std::size_t row) const {
  return square.mix(integrals_[square.lower * rows_ + row], integrals_[square.upper * rows_ + row]);
}

AdaptiveWarp::Warped AdaptiveWarp::sample(const AxisPlace& square, SquarePoint uniform) const {
  const double row_steps = static_cast<double>(rows_ - 1), column_steps = static_cast<double>(columns_ - 1);
  const std::size_t row = node_below(rows_, uniform.y, [&](std::size_t r) { return integral(square, r); });
  const double row_0 = row_integral(square, row, columns_ - 1),
               row_1 = row_integral(square, row + 1, columns_ - 1);
  const double y = inverse_of_linear((uniform.y - integral(square, row)) * row_steps, row_0, row_1);

  const auto conditional = [&](std::size_t column) {
    return std::lerp(row_integral(square, row, column), row_integral(square, row + 1, column), y);
  };
  const double along = uniform.x * std::lerp(row_0, row_1, y);
  const std::size_t column = node_below(columns_, along, conditional);
  const double v0 = std::lerp(value(square, row, column), value(square, row + 1, column), y);
  const double v1 = std::lerp(value(square, row, column + 1), value(square, row + 1, column + 1), y);
  const double x = inverse_of_linear((along - conditional(column)) * column_steps, v0, v1);
  return {{(static_cast<double>(column) + x) / column_steps, (static_cast<double>(row) + y) / row_steps},
          std::lerp(v0, v1, x)};
}

AdaptiveWarp::Warped AdaptiveWarp::invert(const AxisPlace& square, SquarePoint warped) const {
  const double row_step = 1 / static_cast<double>(rows_ - 1),
               column_step = 1 / static_cast<double>(columns_ - 1);
  const Cell row(warped.y, rows_), column(warped.x, columns_);
  const auto across = [&](auto&& of_row) {
    return std::lerp(of_row(row.node), of_row(row.node + 1), row.rest);
  };
  const double v0 = across([&](std::size_t r) { return value(square, r, column.node); });
  const double v1 = across([&](std::size_t r) { return value(square, r, column.node + 1); });
  const double along = across([&](std::size_t r) { return row_integral(square, r, column.node); }) +
                       column_step * integral_of_linear(column.rest, v0, v1);
  const double row_0 = row_integral(square, row.node, columns_ - 1),
               row_1 = row_integral(square, row.node + 1, columns_ - 1);
  return {{along / std::lerp(row_0, row_1, row.rest),
           integral(square, row.node) + row_step * integral_of_linear(row.rest, row_0, row_1)},
          std::lerp(v0, v1, column.rest)};
}

double AdaptiveWarp::density(const AxisPlace& square, SquarePoint point) const {
  const Cell row(point.y, rows_), column(point.x, columns_);
  const auto of_row = [&](std::size_t r) {
    return std::lerp(value(square, r, column.node), value(square, r, column.node + 1), column.rest);
  };
  return std::lerp(of_row(row.node), of_row(row.node + 1), row.rest);
}

}  // namespace brdftab

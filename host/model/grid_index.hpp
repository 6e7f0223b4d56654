// Where a node of a grid lies in a table: its index on each of the four axes, and its place in their order.
#pragma once

#include <cstddef>

#include "host/model/axis.hpp"

namespace brdftab {

/// The index of a node on each axis, in the order of a table's dimensions.
struct GridNode {
  std::size_t theta_i;
  std::size_t phi_i;
  std::size_t theta_s;
  std::size_t phi_s;

  std::size_t& operator[](AxisKind kind) { return this->*member(kind); }
  std::size_t operator[](AxisKind kind) const { return this->*member(kind); }
  bool operator==(const GridNode&) const = default;

  /// The sum on each axis.
  GridNode operator+(const GridNode& other) const {
    return {theta_i + other.theta_i, phi_i + other.phi_i, theta_s + other.theta_s, phi_s + other.phi_s};
  }

 private:
  static constexpr std::size_t GridNode::*member(AxisKind kind) {
    switch (kind) {
      case AxisKind::theta_i:
        return &GridNode::theta_i;
      case AxisKind::phi_i:
        return &GridNode::phi_i;
      case AxisKind::theta_s:
        return &GridNode::theta_s;
      default:
        return &GridNode::phi_s;
    }
  }
};

/// The order [theta_i][phi_i][theta_s][phi_s] of a table's nodes, phi_s running fastest.
class GridIndex {
 public:
  /// `shape` holds the number of nodes on each axis.
  constexpr explicit GridIndex(const GridNode& shape) : shape_(shape) {}
  explicit GridIndex(const Grid& grid)
      : GridIndex(GridNode{grid.theta_i.size(), grid.phi_i.size(), grid.theta_s.size(), grid.phi_s.size()}) {}

  const GridNode& shape() const { return shape_; }
  std::size_t size() const { return rows() * shape_.phi_s; }
  /// Rows of phi_s.
  std::size_t rows() const { return shape_.theta_i * shape_.phi_i * shape_.theta_s; }

  /// The place of a node among all nodes.
  std::size_t flat(const GridNode& node) const {
    return ((node.theta_i * shape_.phi_i + node.phi_i) * shape_.theta_s + node.theta_s) * shape_.phi_s +
           node.phi_s;
  }

  /// The node at a place: the inverse of flat().
  GridNode node(std::size_t flat) const {
    const std::size_t row = flat / shape_.phi_s;
    const std::size_t incidence = row / shape_.theta_s;
    return {incidence / shape_.phi_i, incidence % shape_.phi_i, row % shape_.theta_s, flat % shape_.phi_s};
  }

 private:
  GridNode shape_;
};

}  // namespace brdftab

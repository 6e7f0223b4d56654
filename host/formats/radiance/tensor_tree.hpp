// In Radiance's tensor tree f is constant over cells of a hypercube, which are smaller where f varies more.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/directions.hpp"

namespace brdftab {

/// A point of the hypercube of rank 3, for isotropic f, has the coordinate (1 - sin theta_i) / 2, and the two
/// of the direction of scatter on the square that Shirley and Chiu map the disk of direction cosines to. That
/// direction is turned so that the light travels towards azimuth 0.
using TreePoint = std::array<double, 3>;

/// Adds the pair of directions of a point whose first coordinate is below 1/2; the rest of the cube is not
/// used.
void add(Directions& directions, const TreePoint& point);

/// Gives the point of a pair.
TreePoint tree_point(const Directions& directions, std::size_t k);

struct TreeRefinement {
  /// Cells across the cube are at most 2^depth.
  int depth;
  /// A cell is cut in eight where f at the centres of those differ by more than this share of their mean.
  double tolerance;
  /// Where the mean is below this, 1/sr, the share is one of this value instead.
  double floor;
  /// Each cell holds the mean of f at the centres of its eighths, or f at its own centre.
  bool average;
};

/// A cube that is not cut.
struct TreeCell {
  std::size_t node;
  TreePoint corner;  // the one nearest to the origin
  double size;

  /// Gives the centres of its eighths, and its own last.
  std::array<TreePoint, 9> centres() const;
};

class TensorTree {
 public:
  /// It gives values at points.
  using Function = std::function<std::vector<double>(const std::vector<TreePoint>&)>;

  /// Makes a tree of rank 3 of a function that is even in the azimuth. The tree is 0 in the half of the cube
  /// that is not used.
  static TensorTree refined(const Function& function, const TreeRefinement& refinement);

  /// Takes the text of <ScatteringData>. Throws BadInput, which says what is wrong in it but not where.
  static TensorTree parsed(std::string_view text);

  /// Gives the text that <ScatteringData> has.
  std::string text() const;

  /// Counts the cells that are not cut.
  std::size_t leaves() const;
  double at(TreePoint point) const;

  /// Gives the cells that are not cut, in the order of the text.
  std::vector<TreeCell> cells() const;
  float value(std::size_t node) const { return values_[node]; }
  void set_value(std::size_t node, float value) { values_[node] = value; }

 private:
  friend class TreeParser;

  bool is_leaf(std::size_t node) const { return first_child_[node] < 0; }
  std::size_t child(std::size_t node, std::size_t k) const {
    return static_cast<std::size_t>(first_child_[node]) + k;
  }
  void cut(std::size_t node);
  /// Makes `to` the image of `from` with the last coordinate reversed.
  void mirror(std::size_t from, std::size_t to);
  void print(std::size_t node, std::string& out) const;
  void collect(const TreeCell& cell, std::vector<TreeCell>& cells) const;

  // Both lists go by node. The eight children of a node that is cut lie together; bit d of a child's number
  // says that it is the upper half in dimension d.
  std::vector<std::int32_t> first_child_{-1};
  std::vector<float> values_{0.0f};
};

}  // namespace brdftab

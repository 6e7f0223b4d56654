#include "host/formats/radiance/tensor_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <span>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::size_t eighths = 8;
constexpr int coarsest_level = 3;
constexpr std::size_t cells_at_once = 1 << 15;

struct Square {
  double a, b;
};

// Quarters of the square become quarters of the disk, with the radius along the axis and the azimuth linear
// across. Source: P. Shirley and K. Chiu, "A low distortion map between disk and square", 1997.
Square disk_from_square(const Square& square) {
  const double a = 2 * square.a - 1, b = 2 * square.b - 1;
  const bool along_a = std::abs(a) > std::abs(b);
  const double radius = along_a ? a : b;
  if (radius == 0) return {0, 0};
  const double phi = std::numbers::pi / 4 * (along_a ? b / a : 2 - a / b);
  return {radius * std::cos(phi), radius * std::sin(phi)};
}

Square square_from_polar(double radius, double phi) {
  // Quarters are numbered counter-clockwise from that around azimuth 0.
  const double quarters = phi / (std::numbers::pi / 2), quarter = std::floor(quarters + 0.5);
  const double across = 2 * (quarters - quarter) * radius;
  const int q = (static_cast<int>(quarter) % 4 + 4) % 4;
  const double a = q == 0 ? radius : q == 1 ? -across : q == 2 ? -radius : across;
  const double b = q == 0 ? across : q == 1 ? radius : q == 2 ? -across : -radius;
  return {(a + 1) / 2, (b + 1) / 2};
}

struct Cell {
  std::size_t node;
  TreePoint corner;
};

TreePoint corner_of_eighth(const TreePoint& corner, double size, std::size_t k) {
  TreePoint result = corner;
  for (std::size_t d = 0; d < result.size(); ++d)
    if (k >> d & 1) result[d] += size / 2;
  return result;
}

TreePoint moved(const TreePoint& point, double by) { return {point[0] + by, point[1] + by, point[2] + by}; }

}  // namespace

void add(Directions& directions, const TreePoint& point) {
  const Square disk = disk_from_square({point[1], point[2]});
  directions.add(degrees(std::asin(1 - 2 * point[0])), degrees(std::asin(std::hypot(disk.a, disk.b))),
                 degrees(std::atan2(disk.b, disk.a)));
}

TreePoint tree_point(const Directions& directions, std::size_t k) {
  const Square square = square_from_polar(std::sin(directions.theta_s[k] / degrees_per_radian),
                                          directions.phi[k] / degrees_per_radian);
  // The half of the cube that is used ends below 1/2.
  return {std::min(0.5 - 0.5 * std::sin(directions.theta_i[k] / degrees_per_radian), std::nextafter(0.5, 0.)),
          square.a, square.b};
}

void TensorTree::cut(std::size_t node) {
  first_child_[node] = static_cast<std::int32_t>(first_child_.size());
  first_child_.resize(first_child_.size() + eighths, -1);
  values_.resize(first_child_.size(), 0.0f);
}

void TensorTree::mirror(std::size_t from, std::size_t to) {
  values_[to] = values_[from];
  if (is_leaf(from)) return;
  cut(to);
  for (std::size_t k = 0; k < eighths; ++k) mirror(child(from, k ^ 4), child(to, k));
}

TensorTree TensorTree::refined(const Function& function, const TreeRefinement& refinement) {
  TensorTree tree;
  tree.cut(0);
  std::vector<Cell> cells{{tree.child(0, 0), {0, 0, 0}}, {tree.child(0, 2), {0, 0.5, 0}}};
  double size = 0.5;
  for (int level = 1; !cells.empty(); ++level, size /= 2) {
    std::vector<Cell> next;
    for (std::size_t begin = 0; begin < cells.size(); begin += cells_at_once) {
      const std::size_t end = std::min(begin + cells_at_once, cells.size());
      std::vector<TreePoint> points;
      for (std::size_t c = begin; c < end; ++c) {
        for (std::size_t k = 0; k < eighths; ++k)
          points.push_back(moved(corner_of_eighth(cells[c].corner, size, k), size / 4));
        if (!refinement.average) points.push_back(moved(cells[c].corner, size / 2));
      }
      const std::size_t stride = points.size() / (end - begin);
      const auto f = function(points);
      for (std::size_t c = begin; c < end; ++c) {
        const std::span<const double> here = std::span(f).subspan((c - begin) * stride, stride);
        const auto of_eighths = here.first(eighths);
        const auto [low, high] = std::minmax_element(of_eighths.begin(), of_eighths.end());
        const double mean = std::accumulate(of_eighths.begin(), of_eighths.end(), 0.) / eighths;
        const bool varies = *high - *low > refinement.tolerance * std::max(mean, refinement.floor);
        if (level < refinement.depth && (level < coarsest_level || varies)) {
          tree.cut(cells[c].node);
          for (std::size_t k = 0; k < eighths; ++k)
            next.push_back({tree.child(cells[c].node, k), corner_of_eighth(cells[c].corner, size, k)});
        } else {
          tree.values_[cells[c].node] = static_cast<float>(refinement.average ? mean : here.back());
        }
      }
    }
    cells = std::move(next);
  }
  tree.mirror(tree.child(0, 0), tree.child(0, 4));
  tree.mirror(tree.child(0, 2), tree.child(0, 6));
  return tree;
}

std::size_t TensorTree::leaves() const {
  return static_cast<std::size_t>(
      std::count_if(first_child_.begin(), first_child_.end(), [](auto first) { return first < 0; }));
}

std::array<TreePoint, 9> TreeCell::centres() const {
  std::array<TreePoint, 9> result;
  for (std::size_t k = 0; k < eighths; ++k) result[k] = moved(corner_of_eighth(corner, size, k), size / 4);
  result[eighths] = moved(corner, size / 2);
  return result;
}

void TensorTree::collect(const TreeCell& cell, std::vector<TreeCell>& cells) const {
  if (is_leaf(cell.node)) {
    cells.push_back(cell);
    return;
  }
  for (std::size_t k = 0; k < eighths; ++k)
    collect({child(cell.node, k), corner_of_eighth(cell.corner, cell.size, k), cell.size / 2}, cells);
}

std::vector<TreeCell> TensorTree::cells() const {
  std::vector<TreeCell> cells;
  collect({0, {0, 0, 0}, 1}, cells);
  return cells;
}

double TensorTree::at(TreePoint point) const {
  std::size_t node = 0;
  while (!is_leaf(node)) {
    std::size_t k = 0;
    for (std::size_t d = 0; d < point.size(); ++d) {
      point[d] *= 2;
      if (point[d] >= 1) {
        k |= std::size_t{1} << d;
        point[d] -= 1;
      }
    }
    node = child(node, k);
  }
  return static_cast<double>(values_[node]);
}

void TensorTree::print(std::size_t node, std::string& out) const {
  const auto append = [&](std::size_t n) { fmt::format_to(std::back_inserter(out), " {:.7g}", values_[n]); };
  out += '{';
  if (is_leaf(node)) {
    append(node);
  } else if (std::all_of(&first_child_[child(node, 0)], &first_child_[child(node, 0)] + eighths,
                         [](auto first) { return first < 0; })) {
    // The leaves are written as a grid of two nodes in each dimension, the last the fastest.
    for (const std::size_t k : {0, 4, 2, 6, 1, 5, 3, 7}) append(child(node, k));
  } else {
    for (std::size_t k = 0; k < eighths; ++k) {
      out += '\n';
      print(child(node, k), out);
    }
  }
  out += " }";
}

std::string TensorTree::text() const {
  std::string out;
  print(0, out);
  return out;
}

class TreeParser {
 public:
  explicit TreeParser(std::string_view text) : text_(text) {}

  TensorTree parse() {
    node(0);
    if (next() != '\0') throw BadInput("text after the last brace");
    return std::move(tree_);
  }

 private:
  char next() {
    while (at_ < text_.size() && (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ','))
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }

  void eat(char wanted) {
    const char found = next();
    if (found != wanted)
      throw BadInput("expected {} and found {}", wanted,
                     found == '\0' ? "the end" : excerpt(text_.substr(at_, 12)));
    ++at_;
  }

  void node(std::size_t n) {
    eat('{');
    if (next() == '{') {
      tree_.cut(n);
      for (std::size_t k = 0; k < eighths; ++k) node(tree_.child(n, k));
    } else {
      std::vector<float> grid;
      while (next() != '}' && next() != '\0') {
        float value = 0;
        const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
        if (error != std::errc()) throw BadInput("{} is not a number", excerpt(text_.substr(at_, 12)));
        at_ = static_cast<std::size_t>(end - text_.data());
        grid.push_back(std::max(value, 0.0f));
      }
      std::size_t across = 1;
      while (across * across * across < grid.size()) across *= 2;
      if (across * across * across != grid.size())
        throw BadInput("a grid of {} values; a tensor tree of rank 3 has 1, 8, 64, ...", grid.size());
      fill(n, grid, across, 0, across);
    }
    eat('}');
  }

  void fill(std::size_t n, const std::vector<float>& grid, std::size_t across, std::size_t corner,
            std::size_t size) {
    if (size == 1) {
      tree_.values_[n] = grid[corner];
      return;
    }
    tree_.cut(n);
    const std::size_t half = size / 2;
    for (std::size_t k = 0; k < eighths; ++k)
      fill(tree_.child(n, k), grid, across,
           corner + half * ((k & 1) * across * across + (k >> 1 & 1) * across + (k >> 2 & 1)), half);
  }

  std::string_view text_;
  std::size_t at_ = 0;
  TensorTree tree_;
};

TensorTree TensorTree::parsed(std::string_view text) { return TreeParser(text).parse(); }

}  // namespace brdftab

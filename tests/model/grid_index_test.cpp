// The order of a table's nodes.
#include "host/model/grid_index.hpp"

#include <gtest/gtest.h>

namespace brdftab {
namespace {

constexpr GridNode shape{2, 3, 4, 5};

TEST(GridIndex, CountsNodesInTheOrderOfNestedLoops) {
  const GridIndex index(shape);
  std::size_t place = 0;
  for (std::size_t i = 0; i < shape.theta_i; ++i)
    for (std::size_t p = 0; p < shape.phi_i; ++p)
      for (std::size_t s = 0; s < shape.theta_s; ++s)
        for (std::size_t q = 0; q < shape.phi_s; ++q) {
          const GridNode node{i, p, s, q};
          EXPECT_EQ(index.flat(node), place);
          EXPECT_EQ(index.node(place), node);
          ++place;
        }
  EXPECT_EQ(index.size(), place);
  EXPECT_EQ(index.rows() * shape.phi_s, place);
}

TEST(GridIndex, TakesItsShapeFromAGrid) {
  Grid grid;
  grid.theta_i = Axis(AxisKind::theta_i, {0, 30});
  grid.phi_i = Axis(AxisKind::phi_i, {0, 10, 20});
  grid.theta_s = Axis(AxisKind::theta_s, {0, 1, 2, 3});
  grid.phi_s = Axis(AxisKind::phi_s, {0, 90, 180, 270, 360});
  EXPECT_EQ(GridIndex(grid).shape(), shape);
  EXPECT_EQ(GridIndex(grid).size(), grid.directions());
}

TEST(GridIndex, NamesTheIndexOfAnAxis) {
  GridNode node{1, 2, 3, 4};
  std::size_t expected = 1;
  for (const AxisRow& row : axis_table) EXPECT_EQ(node[row.kind], expected++);
  node[AxisKind::theta_s] = 7;
  EXPECT_EQ(node, (GridNode{1, 2, 7, 4}));
}

}  // namespace
}  // namespace brdftab

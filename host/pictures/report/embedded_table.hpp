// A page carries the samples of a table; of a large table it carries those at some of the nodes.
#pragma once

#include <string>
#include <vector>

#include "host/base/watch.hpp"
#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

/// Some nodes of a grid at its first phi_i, as indices that increase.
struct NodeSubset {
  std::vector<std::size_t> theta_i, theta_s, phi_s;

  std::size_t size() const { return theta_i.size() * theta_s.size() * phi_s.size(); }
};

/// Chooses at most `most` nodes at the first phi_i. They are spread evenly over each axis and include its two
/// ends. The longest axis is thinned first, where the length of phi_s counts half.
NodeSubset spread_nodes(const Grid& grid, std::size_t most);

/// The grid that has just these nodes.
Grid subset_grid(const Grid& grid, const NodeSubset& nodes);

struct EmbeddedTable {
  NodeSubset nodes;
  bool whole;                // whether the nodes are all that the table has at its first phi_i
  drawing::ChartAxis scale;  // of the colours
  std::string json;          // the axes, and the names of the sets of samples
  std::string float32;       // the samples [set][theta_i][theta_s][phi], little-endian, in base64
};

/// Reads the samples of all bands and polarisations, at most `most` of them together.
EmbeddedTable embed(const Subject& table, std::size_t most, const Watch& watch);

}  // namespace brdftab

// A table's samples as a page carries them: some of its nodes, if there are too many.
#pragma once

#include <string>
#include <vector>

#include "host/base/watch.hpp"
#include "host/pictures/drawing/chart_axis.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

/// Indices of nodes, increasing.
struct NodeSubset {
  std::vector<std::size_t> theta_i, theta_s, phi_s;

  std::size_t size() const { return theta_i.size() * theta_s.size() * phi_s.size(); }
};

/// At most `most` nodes at the first phi_i, spread evenly over each axis, both ends of each included: the
/// longest axis is thinned first, phi_s counting half.
NodeSubset spread_nodes(const Grid& grid, std::size_t most);

/// The grid of those nodes.
Grid subset_grid(const Grid& grid, const NodeSubset& nodes);

struct EmbeddedTable {
  NodeSubset nodes;
  bool whole;           // whether nodes are all of the table's at its first phi_i
  ChartAxis scale;      // of colours
  std::string json;     // of the page: axes, and names of the sets of samples
  std::string float32;  // base64, little-endian, [set][theta_i][theta_s][phi]
};

/// All bands and polarisations, in at most `most` samples together.
EmbeddedTable embed(const Subject& table, std::size_t most, const Watch& watch);

}  // namespace brdftab

// A contiguous piece of a table, small enough to hold in memory.
#pragma once

#include <cstddef>
#include <vector>

#include "host/model/axis.hpp"

namespace brdftab {

/// Half-open.
struct Range {
  std::size_t begin;
  std::size_t end;
  std::size_t size() const { return end - begin; }
  bool operator==(const Range&) const = default;
};

/// Cuts a range into pieces of `longest`, the last of what is left.
std::vector<Range> pieces(Range whole, std::size_t longest);

/// Nodes of one dataset and band: a box over the first three angles, all of phi_s.
struct Slab {
  Range theta_i;
  Range phi_i;
  Range theta_s;
  std::size_t phi_s;  // nodes
  std::size_t nodes() const { return theta_i.size() * phi_i.size() * theta_s.size() * phi_s; }
};

/// Nodes of a chunk along the first three angles; it holds all of phi_s. An axis is cut only where the axes
/// before it are cut into single nodes, so a chunk, like a slab, is contiguous in the table's order.
struct Chunk {
  std::size_t theta_i = 1;
  std::size_t phi_i = 1;
  std::size_t theta_s = 1;
};

/// At most `most` of the indices below `count`, spread evenly, both ends included.
std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most);

/// Cuts a grid, in the table's order, into slabs of whole chunks and at most `most_nodes` (or one chunk).
/// Without a chunk, rows of phi_s are not cut.
std::vector<Slab> slabs(const Grid& grid, std::size_t most_nodes, const Chunk& chunk = {});

}  // namespace brdftab

// The shape of the pieces that a table file compresses, each by itself.
#pragma once

#include <cstddef>

#include "host/model/axis.hpp"

namespace brdftab {

/// Nodes of a chunk along the first three angles; it holds all of phi_s. An axis is cut only where the axes
/// before it are cut into single nodes, so a chunk, like a slab, is contiguous in the table's order.
struct Chunk {
  std::size_t theta_i = 1;
  std::size_t phi_i = 1;
  std::size_t theta_s = 1;
};

/// One hemisphere (theta_s, phi_s); several, of neighbouring phi_i and then theta_i, where it is small; some
/// of its rows where it exceeds 1 MiB, which is what HDF5's readers keep of a dataset by default. A function
/// of the grid alone, so that a file does not depend on how it was computed.
Chunk chunk_shape(const Grid& grid, std::size_t node_bytes);

}  // namespace brdftab

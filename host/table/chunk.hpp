// The shape of the pieces that a table file compresses, each by itself.
#pragma once

#include <cstddef>

#include "host/compute/slab.hpp"

namespace brdftab {

/// One hemisphere (theta_s, phi_s); several, of neighbouring phi_i and then theta_i, where it is small; some
/// of its rows where it exceeds 1 MiB, which is what HDF5's readers keep of a dataset by default. A function
/// of the grid alone, so that a file does not depend on how it was computed.
Chunk chunk_shape(const Grid& grid, std::size_t node_bytes);

}  // namespace brdftab

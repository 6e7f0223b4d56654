#include "host/table/chunk.hpp"

#include <algorithm>

namespace brdftab {
namespace {

// Hemispheres are merged up to `wanted`; none is cut below `largest`.
constexpr std::size_t wanted_bytes = 256 << 10;
constexpr std::size_t largest_bytes = 1 << 20;

// The nodes of the even pieces of an axis, as few as have at most `most` nodes each.
std::size_t even_piece(std::size_t nodes, std::size_t most) {
  const std::size_t pieces = (nodes + most - 1) / most;
  return (nodes + pieces - 1) / pieces;
}

}  // namespace

Chunk chunk_shape(const Grid& grid, std::size_t node_bytes) {
  const std::size_t row = grid.phi_s.size() * node_bytes;
  const std::size_t hemisphere = row * grid.theta_s.size();
  const std::size_t incidence = hemisphere * grid.phi_i.size();
  if (hemisphere > largest_bytes)
    return {1, 1, even_piece(grid.theta_s.size(), std::max<std::size_t>(largest_bytes / row, 1))};
  if (incidence > wanted_bytes)
    return {1, even_piece(grid.phi_i.size(), std::max<std::size_t>(wanted_bytes / hemisphere, 1)),
            grid.theta_s.size()};
  return {even_piece(grid.theta_i.size(), wanted_bytes / incidence), grid.phi_i.size(), grid.theta_s.size()};
}

}  // namespace brdftab

#include "host/compute/slab.hpp"

#include <algorithm>

namespace brdftab {

std::vector<Range> pieces(Range whole, std::size_t longest) {
  std::vector<Range> result;
  for (std::size_t begin = whole.begin; begin < whole.end; begin += longest)
    result.push_back({begin, std::min(begin + longest, whole.end)});
  return result;
}

std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most) {
  std::vector<std::size_t> result;
  const std::size_t taken = std::min(count, most);
  for (std::size_t k = 0; k < taken; ++k) result.push_back(taken == 1 ? 0 : k * (count - 1) / (taken - 1));
  return result;
}

std::vector<Slab> slabs(const Grid& grid, std::size_t most_nodes, const Chunk& chunk) {
  const std::size_t row = grid.phi_s.size();
  const std::size_t slice = row * grid.theta_s.size();
  const std::size_t incidence = slice * grid.phi_i.size();
  const auto whole_chunks = [](std::size_t nodes, std::size_t step) {
    return std::max(nodes - nodes % step, step);
  };
  // A dimension is cut only where everything inside it does not fit, so a slab is contiguous.
  const std::size_t theta_i = whole_chunks(most_nodes / incidence, chunk.theta_i);
  const std::size_t phi_i =
      incidence <= most_nodes ? grid.phi_i.size() : whole_chunks(most_nodes / slice, chunk.phi_i);
  const std::size_t theta_s =
      slice <= most_nodes ? grid.theta_s.size() : whole_chunks(most_nodes / row, chunk.theta_s);
  std::vector<Slab> result;
  for (const Range i : pieces({0, grid.theta_i.size()}, theta_i))
    for (const Range p : pieces({0, grid.phi_i.size()}, phi_i))
      for (const Range s : pieces({0, grid.theta_s.size()}, theta_s)) result.push_back({i, p, s, row});
  return result;
}

}  // namespace brdftab

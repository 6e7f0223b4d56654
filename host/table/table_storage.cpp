#include "host/table/table_storage.hpp"

#include <vector>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/relative_azimuth.hpp"
#include "host/table/chunk.hpp"

namespace brdftab {

Grid stored_grid(const Grid& dense, const TableStorage& storage) {
  if (storage.layout == Layout::contiguous) return dense;
  return {dense.theta_i, Axis(AxisKind::phi_i, {0}), dense.theta_s,
          relative_azimuth(dense.phi_i, dense.phi_s).phi};
}

std::string storage_text(const TableStorage& storage, const Grid& dense, Precision precision) {
  std::vector<std::string> notes;
  if (storage.layout == Layout::virtual_view) notes.emplace_back("a view over phi_s - phi_i");
  if (storage.deflate_level > 0) {
    const Grid grid = stored_grid(dense, storage);
    const Chunk chunk = chunk_shape(grid, bytes_of(precision));
    const bool view = storage.layout == Layout::virtual_view;
    notes.push_back(fmt::format("deflate {} in chunks of {} theta_i x {}{} theta_s x {} {}",
                                storage.deflate_level, chunk.theta_i,
                                view ? "" : fmt::format("{} phi_i x ", chunk.phi_i), chunk.theta_s,
                                grid.phi_s.size(), view ? "phi" : "phi_s"));
  }
  if (storage.keep_bits) notes.push_back(fmt::format("{} mantissa bits", *storage.keep_bits));
  return fmt::format("{}", fmt::join(notes, "; "));
}

int parse_compression(std::string_view text) {
  constexpr std::string_view method = "deflate";
  std::string_view level = text.substr(0, method.size()) == method ? text.substr(method.size()) : "unknown";
  if (level.empty()) return 1;
  if (level.front() == ':') {
    const auto number = parse_number(level.substr(1));
    for (int k = 1; k <= strongest_deflate; ++k)
      if (number == k) return k;
  }
  throw BadInput(
      "--compress {}: must be deflate or deflate:LEVEL, LEVEL a whole number from 1 (fastest) to {}",
      excerpt(text), strongest_deflate);
}

}  // namespace brdftab

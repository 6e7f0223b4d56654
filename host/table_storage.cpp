#include "host/table_storage.hpp"

#include "host/error.hpp"
#include "host/numbers.hpp"
#include "host/relative_azimuth.hpp"

namespace brdftab {

Grid stored_grid(const Grid& dense, const TableStorage& storage) {
  if (storage.layout == Layout::contiguous) return dense;
  return {dense.theta_i, Axis(AxisKind::phi_i, {0}), dense.theta_s, relative_azimuth(dense.phi_i, dense.phi_s).phi};
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
  throw BadInput("--compress {}: must be deflate or deflate:LEVEL, LEVEL a whole number from 1 (fastest) to {}", excerpt(text),
                 strongest_deflate);
}

}  // namespace brdftab

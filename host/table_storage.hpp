// How a table file stores its samples.
#pragma once

#include <optional>
#include <string_view>

namespace brdftab {

inline constexpr int strongest_deflate = 12;

struct TableStorage {
  int deflate_level = 0;         // 1 to 12, libdeflate's; 0: not compressed
  std::optional<int> keep_bits;  // explicit bits of each mantissa; none: as computed
};

/// The level that `deflate` or `deflate:LEVEL` asks for. Throws BadInput.
int parse_compression(std::string_view text);

}  // namespace brdftab

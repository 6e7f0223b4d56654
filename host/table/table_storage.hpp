// How a table file stores its samples.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "host/model/axis.hpp"
#include "host/model/precision.hpp"

namespace brdftab {

inline constexpr int strongest_deflate = 12;

enum class Layout { contiguous, virtual_view };

struct TableStorage {
  int deflate_level = 0;         // 1 to 12, libdeflate's; 0: not compressed
  std::optional<int> keep_bits;  // explicit bits of each mantissa; none: as computed
  Layout layout = Layout::contiguous;
};

/// The nodes whose samples are computed and stored: those of the table, or, for a view, those of theta_i,
/// theta_s and phi = phi_s - phi_i, with phi in phi_s's place and 0 as the one phi_i. Throws BadInput where a
/// view cannot be had.
Grid stored_grid(const Grid& dense, const TableStorage& storage);

/// What is not plain about the storage of a table, in words; empty where all is.
std::string storage_text(const TableStorage& storage, const Grid& dense, Precision precision);

/// The level that `deflate` or `deflate:LEVEL` asks for. Throws BadInput.
int parse_compression(std::string_view text);

}  // namespace brdftab

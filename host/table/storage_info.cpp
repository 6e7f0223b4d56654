#include "host/table/storage_info.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brdftab {

std::string StorageInfo::text() const {
  if (layout == "virtual") return fmt::format("a view of {}", view_of);
  std::string text = layout;
  if (!chunk.empty()) text += fmt::format(", {} nodes each", fmt::join(chunk, " x "));
  if (!filters.empty()) text += fmt::format(", {}", fmt::join(filters, ", "));
  text += fmt::format(": {:.4g} MB", static_cast<double>(bytes) / 1e6);
  if (!filters.empty()) text += fmt::format(", ratio {:.2f}", ratio);
  return text;
}

}  // namespace brdftab

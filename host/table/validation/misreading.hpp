// Why a table disagrees with its material: the mistakes that files suffer, each tried on the samples
// themselves.
#pragma once

#include <string>

#include "host/table/validation/node_check.hpp"

namespace brdftab {

/// What would make the samples right, in words; empty where nothing that is tried does. Tried are: axes in
/// radians, two axes swapped, an axis reversed, azimuth counted from the backward side.
std::string find_misreading(const std::vector<reference::Model>& models, TableReader& reader,
                            const StoredTable& table, double tolerance);

}  // namespace brdftab

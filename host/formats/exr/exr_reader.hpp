// The OpenEXR table of interface.md, read back.
#pragma once

#include <filesystem>
#include <memory>

#include "host/table/table_reader.hpp"

namespace brdftab {

/// A file, or a folder with a file for each slice. Throws FileError where it cannot be read, and BadInput
/// where it is not a table of this program.
std::unique_ptr<TableReader> open_exr_reader(const std::filesystem::path& path);

}  // namespace brdftab

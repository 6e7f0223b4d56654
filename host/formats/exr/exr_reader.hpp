// The OpenEXR table that host/FORMATS.md describes, read back.
#pragma once

#include <filesystem>
#include <memory>

namespace brdftab {

class TableReader;

/// A file, or a folder with a file for each slice. Throws FileError where it cannot be read, and BadInput
/// where it is not a table of this program.
std::unique_ptr<TableReader> open_exr_reader(const std::filesystem::path& path);

}  // namespace brdftab

// Any table file that this program writes, opened for reading.
#pragma once

#include <filesystem>
#include <memory>

#include "host/table/table_reader.hpp"

namespace brdftab {

/// Opens by the file's first bytes; a folder holds the slices of an OpenEXR table. Throws FileError where it
/// cannot be read, a truncated one included, and BadInput where it is not a table of this program.
std::unique_ptr<TableReader> open_table(const std::filesystem::path& path);

/// Whether a file is to be opened as a table: a folder, what is named as one, or begins as HDF5 or OpenEXR
/// does; "-" is not.
bool is_table(const std::filesystem::path& file);

}  // namespace brdftab

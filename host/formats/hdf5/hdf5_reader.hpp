// The HDF5 table of interface.md, read back.
#pragma once

#include <filesystem>
#include <memory>

#include "host/table/table_reader.hpp"

namespace brdftab {

/// Throws FileError where the file cannot be read, and BadInput where it is not a table of this program.
std::unique_ptr<TableReader> open_hdf5_reader(const std::filesystem::path& file);

}  // namespace brdftab

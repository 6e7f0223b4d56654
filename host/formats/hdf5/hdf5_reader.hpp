// The HDF5 table that host/FORMATS.md describes, read back.
#pragma once

#include <filesystem>
#include <memory>

namespace brdftab {

class TableReader;

/// Throws FileError where the file cannot be read, and BadInput where it is not a table of this program.
std::unique_ptr<TableReader> open_hdf5_reader(const std::filesystem::path& file);

}  // namespace brdftab

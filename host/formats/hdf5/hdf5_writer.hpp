// The HDF5 table that host/FORMATS.md describes: root-level datasets with dimension scales and CF attributes,
// as h5py, xarray, ncdump, MATLAB and Octave read them without a plug-in.
#pragma once

#include <filesystem>
#include <memory>

namespace brdftab {

class TableWriter;
struct TableContent;

/// Creates the file over an existing (empty) one and allocates every dataset. Throws FileError.
std::unique_ptr<TableWriter> create_hdf5_writer(const std::filesystem::path& file,
                                                const TableContent& content);

}  // namespace brdftab

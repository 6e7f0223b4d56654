// The HDF5 table of interface.md: root-level datasets with dimension scales and CF attributes, as h5py,
// xarray, ncdump, MATLAB and Octave read them without a plug-in.
#pragma once

#include <filesystem>
#include <memory>

#include "host/table/table_writer.hpp"

namespace brdftab {

/// Creates the file over an existing (empty) one and allocates every dataset. Throws FileError.
std::unique_ptr<TableWriter> create_hdf5_writer(const std::filesystem::path& file,
                                                const TableContent& content);

}  // namespace brdftab

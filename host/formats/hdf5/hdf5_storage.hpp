// How an HDF5 dataset is stored.
#pragma once

#include <hdf5.h>

#include "host/table/storage_info.hpp"

namespace brdftab {

/// Throws FileError.
StorageInfo storage_of(hid_t dataset);

}  // namespace brdftab

// How an HDF5 dataset is stored.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <string>
#include <vector>

namespace brdftab {

struct Hdf5Storage {
  std::string layout;  // contiguous, chunked, virtual or other
  std::vector<std::size_t> chunk;
  std::vector<std::string> filters;
  std::string view_of;  // the dataset that a virtual one shows
  std::size_t bytes;    // in the file
  double ratio;         // of the samples' bytes to those in the file; 0 where there are none

  /// In words.
  std::string text() const;
};

/// Throws FileError.
Hdf5Storage storage_of(hid_t dataset);

}  // namespace brdftab

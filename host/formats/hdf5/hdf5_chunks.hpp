// Chunks of a table are compressed by threads of this program and written to HDF5 as they are, since HDF5's
// own filters use one thread. Those filters only ever read them.
#pragma once

#include <hdf5.h>

#include <functional>
#include <span>
#include <vector>

#include "host/compute/slab.hpp"
#include "host/formats/hdf5/chunk_deflater.hpp"

namespace brdftab {

class Hdf5Chunks {
 public:
  using Position = std::function<std::vector<hsize_t>(const Slab& chunk)>;

  Hdf5Chunks(const Grid& grid, std::size_t node_bytes, int deflate_level);

  const Chunk& shape() const { return shape_; }

  /// Sets chunks of `dimensions`, shuffle and deflate as a dataset's properties. Throws FileError.
  void set_filters(hid_t creation, const std::vector<hsize_t>& dimensions) const;

  /// Writes a slab of whole chunks; `position` gives the coordinates of a chunk's first node in the dataset.
  /// Throws FileError.
  void write(hid_t dataset, const Slab& slab, std::span<const std::byte> samples, const Position& position);

 private:
  Chunk shape_;
  std::size_t node_bytes_;
  int deflate_level_;
  ChunkDeflater deflater_;
};

}  // namespace brdftab

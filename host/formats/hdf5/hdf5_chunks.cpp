#include "host/formats/hdf5/hdf5_chunks.hpp"

#include <algorithm>

#include "host/formats/hdf5/hdf5_handle.hpp"
#include "host/table/chunk.hpp"

namespace brdftab {
namespace {

constexpr int highest_zlib_level = 9;

std::size_t chunk_bytes(const Grid& grid, const Chunk& chunk, std::size_t node_bytes) {
  return chunk.theta_i * chunk.phi_i * chunk.theta_s * grid.phi_s.size() * node_bytes;
}

}  // namespace

Hdf5Chunks::Hdf5Chunks(const Grid& grid, std::size_t node_bytes, int deflate_level)
    : shape_(chunk_shape(grid, node_bytes)),
      node_bytes_(node_bytes),
      deflate_level_(deflate_level),
      deflater_(chunk_bytes(grid, shape_, node_bytes), node_bytes, deflate_level) {}

void Hdf5Chunks::set_filters(hid_t creation, const std::vector<hsize_t>& dimensions) const {
  hdf5_check(H5Pset_chunk(creation, static_cast<int>(dimensions.size()), dimensions.data()), "chunks");
  hdf5_check(H5Pset_shuffle(creation), "shuffle");
  // Readers do not need the level, and HDF5 knows zlib's only.
  hdf5_check(H5Pset_deflate(creation, static_cast<unsigned>(std::min(deflate_level_, highest_zlib_level))),
             "deflate");
}

void Hdf5Chunks::write(hid_t dataset, const Slab& slab, std::span<const std::byte> samples,
                       const Position& position) {
  std::vector<std::span<const std::byte>> chunks;
  std::vector<std::vector<hsize_t>> positions;
  std::size_t done = 0;
  // In the table's order chunks follow one another without a gap.
  for (const Range i : pieces(slab.theta_i, shape_.theta_i))
    for (const Range p : pieces(slab.phi_i, shape_.phi_i))
      for (const Range s : pieces(slab.theta_s, shape_.theta_s)) {
        const Slab chunk{i, p, s, slab.phi_s};
        positions.push_back(position(chunk));
        chunks.push_back(samples.subspan(done, chunk.nodes() * node_bytes_));
        done += chunks.back().size();
      }
  deflater_.deflate(chunks, [&](std::size_t k, ChunkDeflater::Stream stream) {
    hdf5_check(H5Dwrite_chunk(dataset, H5P_DEFAULT, 0, positions[k].data(), stream.size(), stream.data()),
               "brdf");
  });
}

}  // namespace brdftab

// All hardware threads compress chunks of samples into what HDF5's shuffle and deflate filters would store.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace brdftab {

class ChunkDeflater {
 public:
  using Stream = std::span<const std::byte>;

  /// A chunk has `chunk_bytes` once it is padded, and a node has `node_bytes`, 4 or 8; `level` is
  /// libdeflate's. Throws std::bad_alloc.
  ChunkDeflater(std::size_t chunk_bytes, std::size_t node_bytes, int level);
  ~ChunkDeflater();

  /// Calls `write` in this thread, in order, with each chunk's zlib stream, while other threads compress
  /// those after it. A chunk shorter than the others is padded with zeros. The bytes do not depend on the
  /// number of threads.
  void deflate(std::span<const std::span<const std::byte>> chunks,
               const std::function<void(std::size_t, Stream)>& write);

 private:
  struct Worker;
  struct Output;

  std::size_t chunk_bytes_;
  std::size_t node_bytes_;
  std::size_t bound_;
  std::vector<std::unique_ptr<Worker>> workers_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

}  // namespace brdftab

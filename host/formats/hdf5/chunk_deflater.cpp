#include "host/formats/hdf5/chunk_deflater.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <new>
#include <thread>

#include "host/base/parallel.hpp"

namespace brdftab {
namespace {

// Writes the first bytes of all numbers, then the second ones, and so on, as HDF5's shuffle filter does on a
// little-endian machine.
template <class Bits>
void shuffle(std::span<const std::byte> numbers, std::byte* planes, std::size_t plane_bytes) {
  const std::size_t count = numbers.size() / sizeof(Bits);
  const auto* in = reinterpret_cast<const Bits*>(numbers.data());
  for (std::size_t plane = 0; plane < sizeof(Bits); ++plane, planes += plane_bytes) {
    auto* out = reinterpret_cast<std::uint8_t*>(planes);
    for (std::size_t k = 0; k < count; ++k) out[k] = static_cast<std::uint8_t>(in[k] >> (8 * plane));
    std::memset(out + count, 0, plane_bytes - count);
  }
}

std::unique_ptr<std::byte[]> room(std::size_t bytes) {
  return std::make_unique_for_overwrite<std::byte[]>(bytes);
}

}  // namespace

struct ChunkDeflater::Worker {
  Worker(std::size_t chunk_bytes, int level)
      : compressor(libdeflate_alloc_compressor(level)), shuffled(room(chunk_bytes)) {
    if (!compressor) throw std::bad_alloc();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  ~Worker() { libdeflate_free_compressor(compressor); }

  libdeflate_compressor* compressor;
  std::unique_ptr<std::byte[]> shuffled;
};

struct ChunkDeflater::Output {
  explicit Output(std::size_t bytes) : stream(room(bytes)) {}

  std::unique_ptr<std::byte[]> stream;
  std::atomic<std::size_t> size = 0;  // 0 until the stream is complete
};

ChunkDeflater::ChunkDeflater(std::size_t chunk_bytes, std::size_t node_bytes, int level)
    : chunk_bytes_(chunk_bytes), node_bytes_(node_bytes) {
  for (std::size_t k = 0; k < hardware_threads(); ++k)
    workers_.push_back(std::make_unique<Worker>(chunk_bytes, level));
  bound_ = libdeflate_zlib_compress_bound(workers_.front()->compressor, chunk_bytes);
}

ChunkDeflater::~ChunkDeflater() = default;

void ChunkDeflater::deflate(std::span<const std::span<const std::byte>> chunks,
                            const std::function<void(std::size_t, Stream)>& write) {
  while (outputs_.size() < chunks.size()) outputs_.push_back(std::make_unique<Output>(bound_));
  for (auto& output : outputs_) output->size = 0;
  std::atomic<std::size_t> next = 0;
  const auto work = [&](Worker& worker) {
    for (std::size_t k; (k = next++) < chunks.size();) {
      const auto shuffle_numbers = node_bytes_ == 8 ? shuffle<std::uint64_t> : shuffle<std::uint32_t>;
      shuffle_numbers(chunks[k], worker.shuffled.get(), chunk_bytes_ / node_bytes_);
      Output& output = *outputs_[k];
      output.size = libdeflate_zlib_compress(worker.compressor, worker.shuffled.get(), chunk_bytes_,
                                             output.stream.get(), bound_);
      output.size.notify_one();
    }
  };
  std::vector<std::jthread> threads;
  // After a failure to write, nobody begins another chunk.
  struct Stop {
    std::atomic<std::size_t>& next;
    std::size_t end;
    ~Stop() { next = end; }
  } stop{next, chunks.size()};
  for (std::size_t k = 0; k < std::min(workers_.size(), chunks.size()); ++k)
    threads.emplace_back(work, std::ref(*workers_[k]));
  for (std::size_t k = 0; k < chunks.size(); ++k) {
    outputs_[k]->size.wait(0);
    write(k, {outputs_[k]->stream.get(), outputs_[k]->size});
  }
}

}  // namespace brdftab

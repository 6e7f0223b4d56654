// Slab buffers that go round between devices and one writing thread, which takes slabs in the table's order.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

#include "host/compute/opencl/engine.hpp"

namespace brdftab {

class SlabRing {
  struct Buffer {
    const Engine* engine;
    cl::Buffer device;
    void* host = nullptr;
    std::size_t bytes = 0;
    bool free = true;
  };

 public:
  using Write = std::function<void(std::span<const std::byte>)>;

  /// A slab to fill: the next one that no device has.
  struct Turn {
    std::size_t slab;
    cl::Buffer samples;
    Buffer* buffer;
  };

  /// For `slabs` slabs of at most `slab_bytes`; `buffers` for each engine.
  SlabRing(std::span<const Engine* const> engines, std::size_t slabs, std::size_t slab_bytes,
           std::size_t buffers = 3);
  SlabRing(const SlabRing&) = delete;
  SlabRing& operator=(const SlabRing&) = delete;
  ~SlabRing();

  /// Waits for a buffer of the engine; none where all slabs below `end` have been taken. Rethrows any
  /// thread's exception.
  std::optional<Turn> take(const Engine& engine, std::size_t end);

  /// Waits for the device, and gives the buffer's first `bytes` for reading on the host.
  std::span<const std::byte> map(const Turn& turn, std::size_t bytes);

  /// Hands the mapped buffer to the writer.
  void submit(const Turn& turn, Write write);

  /// Ends all work with the current exception, which `take` and `drain` rethrow.
  void fail();

  /// Rethrows any thread's exception.
  void rethrow();

  /// Waits until all that was submitted is written. Rethrows any thread's exception.
  void drain();

 private:
  struct Job {
    Buffer* buffer;
    Write write;
  };

  void write_jobs(std::stop_token stop);
  void rethrow_failure() const;

  std::vector<Buffer> buffers_;
  std::size_t next_slab_ = 0;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::map<std::size_t, Job> jobs_;  // by slab
  std::size_t next_job_ = 0;
  std::exception_ptr failure_;
  std::jthread writer_;
};

}  // namespace brdftab

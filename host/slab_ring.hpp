// Slab buffers that go round between a device and one writing thread.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <queue>
#include <span>
#include <thread>
#include <vector>

#include "host/engine.hpp"

namespace brdftab {

class SlabRing {
 public:
  using Write = std::function<void(std::span<const std::byte>)>;

  SlabRing(const Engine& engine, std::size_t slab_bytes, std::size_t buffers = 3);
  SlabRing(const SlabRing&) = delete;
  SlabRing& operator=(const SlabRing&) = delete;
  ~SlabRing();

  /// A buffer that the device may fill; waits until the writer has given one back. Rethrows the writer's exception.
  cl::Buffer& acquire();

  /// Waits for the device, and gives the buffer's first `bytes` for reading on the host.
  std::span<const std::byte> map(std::size_t bytes);

  /// Hands the mapped buffer to the writer.
  void submit(Write write);

  /// Waits until all is written. Rethrows the writer's exception.
  void drain();

 private:
  struct Buffer {
    cl::Buffer device;
    void* host = nullptr;
    std::size_t bytes = 0;
  };
  struct Job {
    std::size_t buffer;
    Write write;
  };

  void write_jobs(std::stop_token stop);
  void rethrow_failure(std::unique_lock<std::mutex>&);

  const Engine& engine_;
  std::vector<Buffer> buffers_;
  std::size_t current_ = 0;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::queue<std::size_t> free_;
  std::queue<Job> jobs_;
  bool writing_ = false;
  std::exception_ptr failure_;
  std::jthread writer_;
};

}  // namespace brdftab

#include "host/table/slab_ring.hpp"

#include <algorithm>

namespace brdftab {

SlabRing::SlabRing(std::span<const Engine* const> engines, std::size_t slabs, std::size_t slab_bytes,
                   std::size_t buffers) {
  const std::size_t each = std::min(buffers, slabs);
  for (const Engine* engine : engines) {
    // On a CPU device a buffer in host memory is mapped without a copy; a GPU computes in its own memory.
    const cl_mem_flags where = engine->device().is_gpu ? 0 : CL_MEM_ALLOC_HOST_PTR;
    for (std::size_t k = 0; k < each; ++k)
      buffers_.push_back({engine, cl::Buffer(engine->context(), CL_MEM_READ_WRITE | where, slab_bytes)});
  }
  writer_ = std::jthread([this](std::stop_token stop) { write_jobs(stop); });
}

SlabRing::~SlabRing() {
  writer_.request_stop();
  writer_.join();
  try {
    for (auto& buffer : buffers_) {
      if (buffer.host) buffer.engine->queue().enqueueUnmapMemObject(buffer.device, buffer.host);
      buffer.engine->queue().finish();
    }
  } catch (const cl::Error&) {
    // The fault that ends the work is already on its way.
  }
}

void SlabRing::rethrow_failure() const {
  if (failure_) std::rethrow_exception(failure_);
}

std::optional<SlabRing::Turn> SlabRing::take(const Engine& engine, std::size_t end) {
  Buffer* buffer = nullptr;
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] {
    const auto free = std::find_if(buffers_.begin(), buffers_.end(),
                                   [&](const Buffer& b) { return b.engine == &engine && b.free; });
    buffer = free == buffers_.end() ? nullptr : &*free;
    return buffer || failure_;
  });
  rethrow_failure();
  if (next_slab_ >= end) return std::nullopt;
  const std::size_t slab = next_slab_++;
  buffer->free = false;
  lock.unlock();
  if (buffer->host)
    engine.queue().enqueueUnmapMemObject(buffer->device, std::exchange(buffer->host, nullptr));
  return Turn{slab, buffer->device, buffer};
}

std::span<const std::byte> SlabRing::map(const Turn& turn, std::size_t bytes) {
  Buffer& buffer = *turn.buffer;
  buffer.host = buffer.engine->queue().enqueueMapBuffer(buffer.device, CL_TRUE, CL_MAP_READ, 0, bytes);
  buffer.bytes = bytes;
  return {static_cast<const std::byte*>(buffer.host), bytes};
}

void SlabRing::submit(const Turn& turn, Write write) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.emplace(turn.slab, Job{turn.buffer, std::move(write)});
  }
  changed_.notify_all();
}

void SlabRing::fail() {
  {
    const std::lock_guard lock(mutex_);
    if (!failure_) failure_ = std::current_exception();
  }
  changed_.notify_all();
}

void SlabRing::rethrow() {
  const std::lock_guard lock(mutex_);
  rethrow_failure();
}

void SlabRing::drain() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return next_job_ == next_slab_ || failure_; });
  rethrow_failure();
}

void SlabRing::write_jobs(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return jobs_.contains(next_job_) && !failure_; })) {
    const Job job = std::move(jobs_.extract(next_job_).mapped());
    lock.unlock();
    try {
      job.write({static_cast<const std::byte*>(job.buffer->host), job.buffer->bytes});
    } catch (...) {
      fail();
      return;
    }
    lock.lock();
    job.buffer->free = true;
    ++next_job_;
    changed_.notify_all();
  }
}

}  // namespace brdftab

#include "host/slab_ring.hpp"

namespace brdftab {

SlabRing::SlabRing(const Engine& engine, std::size_t slab_bytes, std::size_t buffers) : engine_(engine), buffers_(buffers) {
  // On a CPU device a buffer in host memory is mapped without a copy; a GPU computes in its own memory.
  const cl_mem_flags where = engine.device().is_gpu ? 0 : CL_MEM_ALLOC_HOST_PTR;
  for (std::size_t k = 0; k < buffers; ++k) {
    buffers_[k].device = cl::Buffer(engine.context(), CL_MEM_READ_WRITE | where, slab_bytes);
    free_.push(k);
  }
  writer_ = std::jthread([this](std::stop_token stop) { write_jobs(stop); });
}

SlabRing::~SlabRing() {
  writer_.request_stop();
  writer_.join();
  try {
    for (auto& buffer : buffers_)
      if (buffer.host) engine_.queue().enqueueUnmapMemObject(buffer.device, buffer.host);
    engine_.queue().finish();
  } catch (const cl::Error&) {
    // The fault that ends the work is already on its way.
  }
}

void SlabRing::rethrow_failure(std::unique_lock<std::mutex>&) {
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

cl::Buffer& SlabRing::acquire() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !free_.empty() || failure_; });
  rethrow_failure(lock);
  current_ = free_.front();
  free_.pop();
  lock.unlock();
  Buffer& buffer = buffers_[current_];
  if (buffer.host) engine_.queue().enqueueUnmapMemObject(buffer.device, std::exchange(buffer.host, nullptr));
  return buffer.device;
}

std::span<const std::byte> SlabRing::map(std::size_t bytes) {
  Buffer& buffer = buffers_[current_];
  buffer.host = engine_.queue().enqueueMapBuffer(buffer.device, CL_TRUE, CL_MAP_READ, 0, bytes);
  buffer.bytes = bytes;
  return {static_cast<const std::byte*>(buffer.host), bytes};
}

void SlabRing::submit(Write write) {
  {
    const std::lock_guard lock(mutex_);
    jobs_.push({current_, std::move(write)});
  }
  changed_.notify_all();
}

void SlabRing::drain() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return (jobs_.empty() && !writing_) || failure_; });
  rethrow_failure(lock);
}

void SlabRing::write_jobs(std::stop_token stop) {
  std::unique_lock lock(mutex_);
  while (changed_.wait(lock, stop, [this] { return !jobs_.empty(); })) {
    const Job job = std::move(jobs_.front());
    jobs_.pop();
    writing_ = true;
    lock.unlock();
    std::exception_ptr failure;
    try {
      const Buffer& buffer = buffers_[job.buffer];
      job.write({static_cast<const std::byte*>(buffer.host), buffer.bytes});
    } catch (...) {
      failure = std::current_exception();
    }
    lock.lock();
    writing_ = false;
    if (failure) {
      failure_ = failure;
      changed_.notify_all();
      return;
    }
    free_.push(job.buffer);
    changed_.notify_all();
  }
}

}  // namespace brdftab

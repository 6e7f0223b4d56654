#include "host/fit/gradient_batch.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <utility>

namespace brdftab {

void GradientBatch::run(std::size_t count, std::size_t at_once,
                        const std::function<void(std::size_t)>& work) const {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr first;
  const std::size_t threads = std::min(count, at_once);
  active_ = threads;
  {
    std::vector<std::jthread> pool;
    for (std::size_t t = 0; t < threads; ++t)
      pool.emplace_back([&] {
        enter();
        try {
          for (std::size_t k = next++; k < count; k = next++) work(k);
        } catch (...) {
          const std::scoped_lock lock(mutex_);
          if (!first) first = std::current_exception();
          next = count;
        }
        leave();
      });
  }
  if (first) std::rethrow_exception(first);
}

void GradientBatch::enter() const {
  const std::scoped_lock lock(mutex_);
  threads_.insert(std::this_thread::get_id());
}

void GradientBatch::leave() const {
  const std::scoped_lock lock(mutex_);
  threads_.erase(std::this_thread::get_id());
  --active_;
  changed_.notify_all();
}

bool GradientBatch::is_gathered() const {
  const std::scoped_lock lock(mutex_);
  return threads_.contains(std::this_thread::get_id());
}

std::vector<BandValues> GradientBatch::evaluate(std::span<const Parameters> bands) const {
  Request request{.bands = {bands.begin(), bands.end()}, .result = {}, .error = {}};
  if (is_gathered())
    gather(request);
  else
    launch({&request});
  if (request.error) std::rethrow_exception(request.error);
  return std::move(request.result);
}

// The thread whose request makes the company complete launches for all.
void GradientBatch::gather(Request& request) const {
  std::unique_lock lock(mutex_);
  waiting_.push_back(&request);
  changed_.notify_all();
  while (!request.done) {
    if (!launching_ && waiting_.size() == active_) {
      const std::vector<Request*> all = std::exchange(waiting_, {});
      launching_ = true;
      lock.unlock();
      launch(all);
      lock.lock();
      launching_ = false;
      for (Request* served : all) served->done = true;
      changed_.notify_all();
    } else {
      changed_.wait(lock);
    }
  }
}

std::vector<std::vector<BandValues>> GradientBatch::evaluate_all(
    std::span<const std::vector<Parameters>> requests) const {
  std::vector<Request> all;
  for (const auto& bands : requests) all.push_back({.bands = bands, .result = {}, .error = {}});
  std::vector<Request*> pointers;
  for (auto& request : all) pointers.push_back(&request);
  launch(pointers);
  std::vector<std::vector<BandValues>> results;
  for (auto& request : all) {
    if (request.error) std::rethrow_exception(request.error);
    results.push_back(std::move(request.result));
  }
  return results;
}

void GradientBatch::launch(const std::vector<Request*>& requests) const {
  const std::scoped_lock lock(launch_mutex_);
  const auto start = std::chrono::steady_clock::now();
  try {
    if (!bands_.empty()) bands_.front().watch().stop_if_asked();
    for (std::size_t b = 0; b < bands_.size(); ++b) {
      std::vector<Parameters> materials;
      for (const Request* request : requests) materials.push_back(request->bands[b]);
      LogBrdfValues all = bands_[b].evaluate(materials);
      const auto values = std::make_shared<const LogBrdfValues>(
          mean_of_exchanges_ ? all.mean_of_exchanges(materials.size()) : std::move(all));
      for (std::size_t k = 0; k < requests.size(); ++k) requests[k]->result.push_back({values, k});
    }
  } catch (...) {
    for (Request* request : requests) request->error = std::current_exception();
  }
  seconds_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  materials_ += requests.size() * bands_.size();
}

double GradientBatch::seconds() const {
  const std::scoped_lock lock(launch_mutex_);
  return seconds_;
}

std::size_t GradientBatch::materials() const {
  const std::scoped_lock lock(launch_mutex_);
  return materials_;
}

}  // namespace brdftab

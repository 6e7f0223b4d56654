#include "host/base/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "host/base/watch.hpp"

namespace brdftab {

std::size_t hardware_threads() { return std::max(std::thread::hardware_concurrency(), 1u); }

void parallel_for(std::size_t count, const std::function<void(std::size_t)>& work, std::stop_token stop) {
  const Watch watch{.progress = {}, .note = {}, .stop = std::move(stop)};
  std::atomic<std::size_t> next = 0;
  std::once_flag failed;
  std::exception_ptr failure;
  const auto take_steps = [&] {
    try {
      for (std::size_t k; (k = next++) < count;) {
        watch.stop_if_asked();
        work(k);
      }
    } catch (...) {
      next = count;
      std::call_once(failed, [&] { failure = std::current_exception(); });
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < std::min(count, hardware_threads()); ++k) others.emplace_back(take_steps);
    take_steps();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace brdftab

// How far long work has come, on standard error: a bar on a terminal, an occasional line elsewhere.
#pragma once

#include <chrono>

#include "host/base/watch.hpp"

namespace brdftab {

class ProgressBar {
 public:
  ProgressBar();
  ~ProgressBar() { clear(); }

  /// Draws nothing in the first second of a piece of work, which begins where `done` is 0.
  void report(const Progress& progress);

 private:
  using Clock = std::chrono::steady_clock;

  std::string line(const Progress& progress, double seconds) const;
  void clear();

  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace brdftab

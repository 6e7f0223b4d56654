// How far long work has come, on standard error: a bar on a terminal, an occasional line elsewhere.
#pragma once

#include <chrono>
#include <string>

namespace brdftab {

class Progress {
 public:
  using Clock = std::chrono::steady_clock;

  /// `total` in the units that `report` counts; `unit_bytes` of data each. Silent if `quiet`, and for the first second.
  Progress(std::string what, std::size_t total, std::size_t unit_bytes, bool quiet);
  ~Progress();

  void report(std::size_t done);

 private:
  std::string line(std::size_t done, double seconds) const;

  std::string what_;
  std::size_t total_;
  std::size_t unit_bytes_;
  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  Clock::time_point start_ = Clock::now();
  Clock::time_point last_ = start_;
};

}  // namespace brdftab

// Evaluations that many threads ask for, gathered into one launch for each list of directions.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <thread>
#include <vector>

#include "host/compute/gradients.hpp"

namespace brdftab {

/// Values of one material at the directions of one band.
struct BandValues {
  std::shared_ptr<const LogBrdfValues> values;
  std::size_t material;
  std::span<const double> ln_f() const { return values->ln_f(material); }
  std::span<const double> by(std::size_t parameter) const { return values->by(material, parameter); }
};

/// Its functions may be called by many threads at once, `run` by one at a time.
class GradientBatch {
 public:
  /// Each band has a list of directions. With `mean_of_exchanges` the lists are by `with_exchanges`, and
  /// values become ln of the mean of f(i, s) and f(s, i), and its derivatives.
  explicit GradientBatch(std::vector<LogBrdfGradients> bands, bool mean_of_exchanges = false)
      : bands_(std::move(bands)), mean_of_exchanges_(mean_of_exchanges) {}

  /// Calls work(0) ... work(count - 1) in `at_once` threads of its own, one item after another in each;
  /// rethrows the first exception, after which no further item begins.
  void run(std::size_t count, std::size_t at_once, const std::function<void(std::size_t)>& work) const;

  /// Takes a parameter set for each band. In a thread of this batch's `run` it waits until every other thread
  /// there asks too or has ended, so that one launch serves all; elsewhere it evaluates at once. Results do
  /// not depend on the company.
  std::vector<BandValues> evaluate(std::span<const Parameters> bands) const;
  /// Evaluates several such requests together.
  std::vector<std::vector<BandValues>> evaluate_all(std::span<const std::vector<Parameters>> requests) const;

  /// Wall time of all launches so far, and how many materials they evaluated.
  double seconds() const;
  std::size_t materials() const;

 private:
  struct Request {
    std::vector<Parameters> bands;
    std::vector<BandValues> result;
    std::exception_ptr error;
    bool done = false;
  };
  void enter() const;
  void leave() const;
  bool is_gathered() const;
  void gather(Request& request) const;
  void launch(const std::vector<Request*>& requests) const;

  std::vector<LogBrdfGradients> bands_;
  bool mean_of_exchanges_;

  mutable std::mutex mutex_;  // of what follows
  mutable std::condition_variable changed_;
  mutable std::set<std::thread::id> threads_;  // of `run`
  mutable std::size_t active_ = 0;  // how many of them there are, those included that have yet to begin
  mutable std::vector<Request*> waiting_;
  mutable bool launching_ = false;

  mutable std::mutex launch_mutex_;  // of what follows, and of the device
  mutable double seconds_ = 0;
  mutable std::size_t materials_ = 0;
};

}  // namespace brdftab

// Evaluations that many threads ask for, gathered into one launch for each list of directions.
#pragma once

#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <span>
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

class GradientBatch {
 public:
  /// One list of directions for each band. `mean_of_exchanges`: the lists are by `with_exchanges`, and values
  /// become ln of the mean of f(i, s) and f(s, i), and its derivatives.
  explicit GradientBatch(std::vector<LogBrdfGradients> bands, bool mean_of_exchanges = false)
      : bands_(std::move(bands)), mean_of_exchanges_(mean_of_exchanges) {}

  /// Calls work(0) ... work(count - 1), each in a thread of its own, `at_once` of them at a time; rethrows
  /// the first exception.
  void run(std::size_t count, std::size_t at_once, const std::function<void(std::size_t)>& work);

  /// One parameter set for each band. In a thread of `run` it waits until every other thread there asks too
  /// or has ended, so that one launch serves all; elsewhere it evaluates at once. Results do not depend on
  /// the company.
  std::vector<BandValues> evaluate(std::span<const Parameters> bands);
  /// Several such requests together.
  std::vector<std::vector<BandValues>> evaluate_all(std::span<const std::vector<Parameters>> requests);

  /// Wall time of all launches, and how many materials they evaluated.
  double seconds() const { return seconds_; }
  std::size_t materials() const { return materials_; }

 private:
  struct Request {
    std::vector<Parameters> bands;
    std::vector<BandValues> result;
    std::exception_ptr error;
    bool done = false;
  };
  void leave();
  void launch(std::vector<Request*> requests);

  std::vector<LogBrdfGradients> bands_;
  bool mean_of_exchanges_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<Request*> waiting_;
  std::size_t active_ = 0;
  bool launching_ = false;
  double seconds_ = 0;
  std::size_t materials_ = 0;
};

}  // namespace brdftab

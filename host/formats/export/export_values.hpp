// The values that a simulator's file holds are compared with those that it should hold.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>

namespace brdftab {

/// Below this value of f, in 1/sr, errors are no longer relative to it: a surface so dark reflects 3e-4.
inline constexpr double error_floor = 1e-4;

/// Counts the values that are off by more than `tolerance` of max(right, error_floor), and keeps the worst.
class ValueErrors {
 public:
  explicit ValueErrors(double tolerance) : tolerance_(tolerance) {}

  /// Sets the share of a value that the file's digits leave open; so much is no error.
  void set_rounding(double share) { rounding_ = share; }

  /// Compares two values of f in 1/sr, or of what stands for it; `place` gives the value's name and angles,
  /// in words.
  template <class Place>
  void compare(double held, double right, const Place& place) {
    ++values_;
    const double difference = std::abs(held - right) - rounding_ * std::max(std::abs(held), std::abs(right));
    const double ratio = difference / std::max(right, error_floor);
    const double error = std::isnan(ratio) ? std::numeric_limits<double>::infinity() : std::max(ratio, 0.);
    if (error > tolerance_) ++wrong_;
    if (!(error > maximum_)) return;
    maximum_ = error;
    held_ = held;
    right_ = right;
    place_ = place();
  }

  std::size_t values() const { return values_; }
  std::size_t wrong() const { return wrong_; }
  double rounding() const { return rounding_; }
  /// |held - right| / max(right, error_floor) of the worst value, without what the digits leave open; and
  /// that value itself.
  double maximum() const { return std::max(maximum_, 0.); }
  double held() const { return held_; }
  double right() const { return right_; }
  const std::string& place() const { return place_; }

 private:
  double tolerance_;
  double rounding_ = 0;
  std::size_t values_ = 0, wrong_ = 0;
  double maximum_ = -1, held_ = 0, right_ = 0;
  std::string place_;
};

}  // namespace brdftab

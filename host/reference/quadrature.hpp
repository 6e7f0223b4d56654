// Adaptive Gauss-Kronrod quadrature of several integrals over shared nodes: Boost's
// nodes and weights, QUADPACK's error estimate, refinement of whatever
// interval spoils the relative accuracy of any component.
#pragma once

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace brdftab::reference {

/// A value and the estimate of its relative error.
struct Estimate {
  double value = 0;
  double error = 0;
};

/// An interval of the variable of one segment of a piecewise parametrised path.
template <class T>
struct Interval {
  T begin;
  T end;
  int segment = 0;
};

template <class T, std::size_t Components>
struct Integral {
  std::array<T, Components> value{};
  std::array<T, Components> error{};  // absolute
};

/// Bounds the work on an integrand whose noise exceeds the tolerance.
inline constexpr std::size_t most_pieces = 4000;

/// Integrates f(segment, x) -> array<T, Components> over all intervals to a relative
/// tolerance of each of the first Guiding components, or as far as `passes`
/// bisections of an interval and `most_pieces` go; the error says how far that was.
template <unsigned Points, std::size_t Components, std::size_t Guiding = Components, class T, class Function>
Integral<T, Components> integrate(const Function& f, const std::vector<Interval<T>>& intervals, T tolerance,
                                  int passes = 60) {
  using Kronrod = boost::math::quadrature::gauss_kronrod<T, Points>;
  using Gauss = boost::math::quadrature::gauss<T, (Points - 1) / 2>;
  static_assert((Points - 1) / 2 % 2 == 1, "Gauss nodes are the even Kronrod nodes");
  using Values = std::array<T, Components>;

  struct Piece {
    Interval<T> interval;
    Values value, error;
  };
  const auto evaluate = [&](const Interval<T>& interval) {
    const auto& nodes = Kronrod::abscissa();
    const auto& weights = Kronrod::weights();
    const auto& gauss_weights = Gauss::weights();
    const T centre = (interval.begin + interval.end) / 2;
    const T half = (interval.end - interval.begin) / 2;
    std::array<Values, Points> samples;
    Piece piece{interval, {}, {}};
    Values gauss{};
    for (std::size_t i = 0; i < nodes.size(); ++i)
      for (int side = i == 0 ? 1 : 0; side < 2; ++side) {
        const Values y = f(interval.segment, centre + (side ? half : -half) * nodes[i]);
        samples[i == 0 ? 0 : 2 * i - 1 + side] = y;
        for (std::size_t k = 0; k < Components; ++k) {
          piece.value[k] += half * weights[i] * y[k];
          if (i % 2 == 0) gauss[k] += half * gauss_weights[i / 2] * y[k];
        }
      }
    for (std::size_t k = 0; k < Components; ++k) {
      const T mean = piece.value[k] / (2 * half);
      T variation = 0;
      for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int side = i == 0 ? 1 : 0; side < 2; ++side)
          variation += half * weights[i] * std::fabs(samples[i == 0 ? 0 : 2 * i - 1 + side][k] - mean);
      const T difference = std::fabs(piece.value[k] - gauss[k]);
      T error = difference;
      if (variation > 0 && difference > 0)
        error = variation * std::min(T(1), std::pow(200 * difference / variation, T(1.5)));
      piece.error[k] = std::max(error, 4 * std::numeric_limits<T>::epsilon() * std::fabs(piece.value[k]));
    }
    return piece;
  };

  std::vector<Piece> pieces;
  for (const Interval<T>& interval : intervals)
    if (interval.end > interval.begin) pieces.push_back(evaluate(interval));

  Integral<T, Components> sum;
  for (int pass = 0;; ++pass) {
    sum = {};
    for (const Piece& piece : pieces)
      for (std::size_t k = 0; k < Components; ++k) {
        sum.value[k] += piece.value[k];
        sum.error[k] += piece.error[k];
      }
    bool done = true;
    for (std::size_t k = 0; k < Guiding; ++k)
      if (sum.error[k] > tolerance * std::fabs(sum.value[k])) done = false;
    if (done || pass == passes || pieces.size() > most_pieces) return sum;

    std::vector<Piece> refined;
    bool changed = false;
    for (const Piece& piece : pieces) {
      const Interval<T>& interval = piece.interval;
      const T middle = (interval.begin + interval.end) / 2;
      bool spoils = false;
      for (std::size_t k = 0; k < Guiding; ++k)
        if (piece.error[k] > 8 * std::numeric_limits<T>::epsilon() * std::fabs(piece.value[k]) &&
            piece.error[k] * T(2 * pieces.size()) > tolerance * std::fabs(sum.value[k]))
          spoils = true;
      if (spoils && middle > interval.begin && middle < interval.end) {
        refined.push_back(evaluate({interval.begin, middle, interval.segment}));
        refined.push_back(evaluate({middle, interval.end, interval.segment}));
        changed = true;
      } else {
        refined.push_back(piece);
      }
    }
    pieces = std::move(refined);
    if (!changed) return sum;
  }
}

}  // namespace brdftab::reference

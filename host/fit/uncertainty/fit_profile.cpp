#include "host/fit/uncertainty/fit_profile.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

namespace brdftab {
namespace {

constexpr std::size_t profiles_at_once = 32;
constexpr int most_points = 16;
// The rise is met to this part, and with it the interval's end to about 1/50 of its half width.
constexpr double tolerance = 0.02;
constexpr Patience patience{.iterations = 60, .tolerance = 1e-7};
// A cost that is lower by this much, in units of the variance, is a better fit and not rounding.
constexpr double better = 0.05;
constexpr int most_repeats = 3;

struct End {
  double u;
  bool open;
};

class Profile {
 public:
  Profile(const FitProblem& problem, const Minimum& best, std::size_t variable, double variance,
          double target)
      : problem_(problem),
        best_(best),
        variable_(variable),
        variance_(variance),
        target_(target),
        held_(best.u.size()) {
    held_[variable] = true;
    lowest_ = best;
  }

  /// Finds where the square root of the rise reaches the target, on the side of `sign`.
  End end(double sign, double standard_error) {
    const FitVariable& v = problem_.variables()[variable_];
    const double bound = v.to_solver(sign > 0 ? v.maximum : v.minimum);
    double inner = best_.u[variable_];
    double inner_rise = 0;
    std::vector<double> inner_point = best_.u;
    if ((bound - inner) * sign < 1e-6) return {bound, true};
    double outer = bound;
    double outer_rise = std::numeric_limits<double>::infinity();
    double step = std::clamp(target_ * standard_error, 1e-7, std::min(0.5, std::abs(bound - inner)));
    for (int k = 0; k < most_points; ++k) {
      double u = inner + sign * step;
      if (std::isfinite(outer_rise)) {
        const double part = (target_ - inner_rise) / (outer_rise - inner_rise);
        u = inner + (outer - inner) * std::clamp(part, 0.05, 0.95);
      } else if ((u - bound) * sign >= 0) {
        u = bound;
      }
      std::vector<double> start = inner_point;
      start[variable_] = u;
      const Minimum there = minimize(problem_, std::move(start), patience, held_);
      const double rise = std::sqrt(std::max(0.0, there.cost - best_.cost) / variance_);
      if (there.cost < lowest_.cost) lowest_ = there;
      if (std::abs(rise - target_) < tolerance * target_) return {u, false};
      if (rise > target_) {
        outer = u;
        outer_rise = rise;
      } else {
        if (u == bound) return {bound, true};
        const double gained = rise / std::max(inner_rise, 1e-3 * target_);
        step = std::abs(u - inner) * (k == 0       ? std::clamp(target_ / std::max(rise, 1e-3) - 1, 0.3, 8.0)
                                      : gained > 4 ? 1.0
                                                   : 2.5);
        inner = u;
        inner_rise = rise;
        inner_point = there.u;
      }
    }
    return {std::isfinite(outer_rise) ? 0.5 * (inner + outer) : inner, !std::isfinite(outer_rise)};
  }

  const Minimum& lowest() const { return lowest_; }

 private:
  const FitProblem& problem_;
  const Minimum& best_;
  std::size_t variable_;
  double variance_;
  double target_;
  std::vector<bool> held_;
  Minimum lowest_;
};

}  // namespace

std::vector<Interval95> profile_intervals(const FitProblem& problem, Minimum& best) {
  const auto& variables = problem.variables();
  for (int repeat = 0;; ++repeat) {
    const LinearUncertainty linear = linear_uncertainty(problem, best);
    const double variance = std::max(linear.variance, 1e-20);
    const double target = student_95(linear.degrees_of_freedom);
    std::vector<End> ends(2 * variables.size());
    Minimum lowest = best;
    std::mutex mutex;
    problem.batch().run(ends.size(), profiles_at_once, [&](std::size_t k) {
      const std::size_t v = k / 2;
      Profile profile(problem, best, v, variance, target);
      const double error = linear.standard_error(v);
      ends[k] = profile.end(k % 2 ? 1 : -1, std::isfinite(error) ? error : 0.1);
      const std::scoped_lock lock(mutex);
      if (profile.lowest().cost < lowest.cost) lowest = profile.lowest();
    });
    if (lowest.cost < best.cost - better * variance && repeat < most_repeats) {
      const Minimum polished = minimize(problem, lowest.u, {.iterations = 400, .tolerance = 1e-13});
      best = polished.cost <= lowest.cost ? polished : lowest;
      continue;
    }
    std::vector<Interval95> result;
    for (std::size_t v = 0; v < variables.size(); ++v) {
      const End& low = ends[2 * v];
      const End& high = ends[2 * v + 1];
      result.push_back({low.open ? variables[v].minimum : variables[v].from_solver(low.u),
                        high.open ? variables[v].maximum : variables[v].from_solver(high.u), low.open,
                        high.open});
    }
    return result;
  }
}

}  // namespace brdftab

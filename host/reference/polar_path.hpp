// The path in θ_s along which the lobes are integrated: u = sin²θ_s from 0 to 1, in
// four segments whose variables flatten the peak at u = sin²θ_i and both ends.
#pragma once

#include <vector>

#include "host/reference/quadrature.hpp"
#include "host/reference/width_shadowing.hpp"

namespace brdftab::reference {

/// A point of the path; du = jacobian · dx.
struct PolarNode {
  Direction out;
  Real u;           // sin²θ_s
  Real offset;      // u − sin²θ_i, without cancellation
  Real log_square;  // ln ρ′²
  Real jacobian;
};

class PolarPath {
 public:
  /// Breakpoints are values of u at which an integrand is not smooth.
  PolarPath(const Direction& in, const Width& width, const std::vector<Real>& breakpoints);

  PolarNode node(int segment, Real x) const;
  const std::vector<Interval<Real>>& intervals() const { return intervals_; }

  const Direction& in() const { return in_; }
  /// ln ρ′² at θ_s = θ_i.
  Real log_square_at_peak() const { return log_square_at_peak_; }
  /// Half-width in u of a core around the peak that the path leaves out, because
  /// the lobe is so narrow that there ρ′² is constant and the integral closed; or 0.
  Real core() const { return core_; }

 private:
  enum Segment { pole, below, above, horizon };
  void add(Segment segment, Real begin, Real end, std::vector<Real> inner, Real longest);
  Real stretch(Real distance) const;

  Direction in_;
  Width width_;
  Real log_shadowing_in_;
  Real log_square_at_peak_;
  Real scale_;  // distance in u over which the peak changes
  Real core_ = 0;
  std::vector<Interval<Real>> intervals_;
};

}  // namespace brdftab::reference

// Segments: pole in sin θ_s and horizon in cos θ_s, as V_m and Fresnel are smooth
// in these; below and above the peak in τ = ln(1 + |u − sin²θ_i|/scale).
#include "host/reference/polar_path.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab::reference {
namespace {

constexpr Real longest_step_in_tau = 6;
// Inside the core u changes by less than 1e-25 of its range and so ln ρ′² by less
// than 1e-20; outside, the lobe's width is below 1e-15 of the distance.
constexpr Real core_fraction = 1e-25L;
constexpr Real width_per_core = 1e-15L;

}  // namespace

PolarPath::PolarPath(const Direction& in, const Width& width, const std::vector<Real>& breakpoints)
    : in_(in), width_(width), log_shadowing_in_(width.log_shadowing(in.sin * in.sin)) {
  const Real u_in = in.sin * in.sin, mu_squared = in.cos * in.cos;
  log_square_at_peak_ = width.log_square(in.cos, in.cos, log_shadowing_in_, log_shadowing_in_);
  const Real p = std::exp(log_square_at_peak_ / 2);
  scale_ = p * p + 2 * in.sin * p;
  const Real candidate = core_fraction * std::min(u_in, mu_squared);
  if (scale_ < width_per_core * candidate) core_ = scale_ = candidate;

  const Real sin_pole = in.sin * std::sqrt(0.5L), cos_horizon = in.cos * std::sqrt(0.5L);
  std::vector<Real> at_pole, at_below, at_above, at_horizon;
  for (const Real fraction : {1 / 256.0L, 1 / 16.0L, 1 / 4.0L}) {
    at_pole.push_back(fraction * sin_pole);
    at_horizon.push_back(fraction * cos_horizon);
    at_below.push_back(stretch(fraction * u_in / 2));
    at_above.push_back(stretch(fraction * mu_squared / 2));
  }
  for (const Real u : breakpoints) {
    if (u <= 0 || u >= 1) continue;
    at_pole.push_back(std::sqrt(u));
    at_horizon.push_back(std::sqrt(1 - u));
    if (u < u_in) at_below.push_back(stretch(u_in - u));
    if (u > u_in) at_above.push_back(stretch(u - u_in));
  }
  add(pole, 0, sin_pole, at_pole, 1);
  add(below, 0, stretch(u_in / 2), at_below, longest_step_in_tau);
  add(above, 0, stretch(mu_squared / 2), at_above, longest_step_in_tau);
  add(horizon, 0, cos_horizon, at_horizon, 1);
}

Real PolarPath::stretch(Real distance) const {
  if (core_ == 0) return std::log1p(distance / scale_);
  return distance > scale_ ? std::log(distance / scale_) : 0;
}

void PolarPath::add(Segment segment, Real begin, Real end, std::vector<Real> inner, Real longest) {
  inner.push_back(end);
  std::sort(inner.begin(), inner.end());
  Real from = begin;
  for (const Real to : inner) {
    if (to <= from || to > end) continue;
    const int steps = static_cast<int>(std::ceil((to - from) / longest));
    for (int i = 0; i < steps; ++i)
      intervals_.push_back({from + (to - from) * i / steps, from + (to - from) * (i + 1) / steps, segment});
    from = to;
  }
}

PolarNode PolarPath::node(int segment, Real x) const {
  const Real u_in = in_.sin * in_.sin, mu_squared = in_.cos * in_.cos;
  PolarNode node{};
  switch (segment) {
    case pole:
      node = {{x, std::sqrt(1 - x * x)}, x * x, x * x - u_in, 0, 2 * x};
      break;
    case horizon:
      node = {{std::sqrt(1 - x * x), x}, 1 - x * x, mu_squared - x * x, 0, 2 * x};
      break;
    default: {
      const Real distance = core_ == 0 ? scale_ * std::expm1(x) : scale_ * std::exp(x);
      node.offset = segment == below ? -distance : distance;
      node.u = u_in + node.offset;
      node.out = {std::sqrt(node.u), std::sqrt(mu_squared - node.offset)};
      node.jacobian = scale_ * std::exp(x);
    }
  }
  node.log_square = width_.log_square(in_.cos, node.out.cos, log_shadowing_in_, width_.log_shadowing(node.u));
  return node;
}

}  // namespace brdftab::reference

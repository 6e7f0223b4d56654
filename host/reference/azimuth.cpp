// With z = ln tan(φ/2), φ counted from the centre of the lobe, both the lobe's
// width, however small, and V_m near its edge at 90° are features of order one:
// cos φ = −tanh z, sin φ = dφ/dz = 1/cosh z. The variable is y = z − ln(width), as only
// that keeps its digits where the width is e^-3000.
#include "host/reference/azimuth.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab::reference {
namespace {

// An order above what doubles allow over the intervals summed.
constexpr double tolerance = 1e-13;
// e^-40 of the lobe is left out at either end.
constexpr double tail = 40;

class Shadowing {
 public:
  Shadowing(const AzimuthLobe& lobe, const PolarNode& node)
      : lobe_(lobe),
        w_a_(static_cast<double>(lobe.shadowing.w_a)),
        w_b_(static_cast<double>(lobe.shadowing.w_b)),
        sin_(static_cast<double>(node.out.sin)),
        mu_squared_(static_cast<double>(node.out.cos * node.out.cos)),
        lit_(static_cast<double>(-std::expm1(-lobe.forward_onset))),
        unlit_(static_cast<double>(std::exp(-lobe.forward_onset))) {}

  double operator()(double z) const {
    if (!lobe_.shadowed) return 1;
    const double alpha = sin_ * std::tanh(lobe_.retro ? z : -z);
    if (alpha == 0) return 1;
    const double beta = sin_ / std::cosh(z);
    const double zeta = std::fabs(alpha) / std::sqrt(mu_squared_ + beta * beta);
    const double s = std::exp(-w_a_ * zeta * std::exp(-w_b_ / (alpha * alpha)));
    return alpha > 0 ? lit_ + s * unlit_ : s;
  }

 private:
  const AzimuthLobe& lobe_;
  double w_a_, w_b_, sin_, mu_squared_, lit_, unlit_;
};

std::vector<Interval<double>> intervals(double log_width) {
  std::vector<double> points{-tail, -12, -4, -1.5, 0, 1.5, 4, 12};
  // On both sides of the edge of V_m at φ = 90°.
  for (const double distance : {0.0, 0.02, 0.1, 0.4, 1.0, 2.5, 6.0, 15.0}) {
    points.push_back(-distance - log_width);
    points.push_back(distance - log_width);
  }
  points.push_back(tail - log_width);
  std::sort(points.begin(), points.end());
  std::vector<Interval<double>> result;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    if (points[i] >= -tail && points[i + 1] > points[i]) result.push_back({points[i], points[i + 1], 0});
  return result;
}

template <class Function>
Ring integrate_over_azimuth(const Function& f, double log_width) {
  const auto integral = integrate<15, 1>([&](int, double y) { return std::array<double, 1>{f(y)}; },
                                         intervals(log_width), tolerance);
  const double value = integral.value[0];
  return {value, value > 0 ? integral.error[0] / value : 0};
}

// With κ² = (A − B)/(A + B): dφ/(A − B cos φ) = dz/cosh(z − ln κ)/√(A² − B²).
Ring lorentzian(const Shadowing& shadowing, const Direction& in, const PolarNode& node) {
  const Real square = std::exp(node.log_square), u_in = in.sin * in.sin;
  const Real difference = node.out.sin + in.sin > 0 ? node.offset / (node.out.sin + in.sin) : 0;
  const Real sum = node.out.sin + in.sin;
  const double log_width =
      static_cast<double>((std::log(difference * difference + square) - std::log(sum * sum + square)) / 2);
  const Ring integral =
      integrate_over_azimuth([&](double y) { return shadowing(y + log_width) / std::cosh(y); }, log_width);
  const Real root = std::sqrt(node.offset * node.offset + square * (2 * (node.u + u_in) + square));
  return {integral.value / root, integral.error};
}

// d² = (s − s₀)² + 4 s s₀ sin²(φ/2), sin²(φ/2) = 1/(1 + e^{−2z}).
Ring gaussian(const Shadowing& shadowing, const Direction& in, const PolarNode& node) {
  const Real square = std::exp(node.log_square);
  const Real sum = node.out.sin + in.sin;
  const Real difference = sum > 0 ? node.offset / sum : 0;
  if (square == 0) return {0, 0};
  const Real decay = difference * difference / (4 * square);
  // Of width 1/√ratio, or of order one, in φ; s s₀ sin²(φ/2)/p² = e^{2y + excess}/(1 + e^{2z}).
  const Real log_ratio = std::log(node.out.sin * in.sin) - node.log_square;
  const Real log_width = std::min<Real>(0, -log_ratio / 2);
  const double excess = static_cast<double>(log_ratio + 2 * log_width);
  const double shift = static_cast<double>(log_width);
  const Ring integral = integrate_over_azimuth(
      [&](double y) {
        const double z = y + shift;
        // dφ/dz = 1/cosh z = width · 2 e^{y}/(1 + e^{2z}), in the form that suits the sign of z.
        const double log_one_plus = std::log1p(std::exp(-2 * std::fabs(z)));
        const double exponent = excess + (z > 0 ? 2 * (y - z) : 2 * y) - log_one_plus;
        return shadowing(z) * 2 * std::exp((z > 0 ? y - 2 * z : y) - log_one_plus - std::exp(exponent));
      },
      shift);
  return {integral.value * std::exp(log_width - decay), integral.error};
}

}  // namespace

Ring azimuth_integral(const AzimuthLobe& lobe, const Direction& in, const PolarNode& node) {
  const Shadowing shadowing(lobe, node);
  return lobe.autocovariance == Autocovariance::gaussian ? gaussian(shadowing, in, node)
                                                         : lorentzian(shadowing, in, node);
}

Real shadowing_at_peak(const AzimuthLobe& lobe, const Direction& in) {
  if (!lobe.shadowed) return 1;
  return reflectance_shadowing(lobe.shadowing, in, in, lobe.retro ? 180 : 0);
}

}  // namespace brdftab::reference

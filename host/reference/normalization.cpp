// The azimuth integral of a lobe is closed, as ρ′ does not depend on φ; what is left
// is an integral over u = sin²θ_s with a peak at u₀ = sin²θ_i.
#include "host/reference/normalization.hpp"

#include <boost/math/special_functions/bessel.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brdftab::reference {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real tolerance = 1e-15L;
// Of the integrand itself, mostly of gamma_q: some tens of ulp of long double.
constexpr Real integrand_error = 1e-17L;

// ½ ∫₀^{2π} dφ/D = π/√(A² − B²), A = u + u₀ + p², B = 2√(u u₀), where
// A² − B² = (u − u₀)² + 2p²(u + u₀) + p⁴ has no cancellation.
Real lorentzian_ring(const PolarNode& node, Real u_in) {
  const Real square = std::exp(node.log_square);
  return pi / std::sqrt(node.offset * node.offset + square * (2 * (node.u + u_in) + square));
}

// ½ ∫₀^{2π} exp(−d²/4p²) dφ = π exp(−(s − s₀)²/4p²) e^{−z} I₀(z), z = s s₀/2p².
Real gaussian_ring(const PolarNode& node, Real sin_in) {
  const Real square = std::exp(node.log_square);
  if (square == 0) return 0;
  const Real difference = node.offset / (node.out.sin + sin_in);
  const Real decay = difference == 0 ? 0 : difference * difference / (4 * square);
  return pi * std::exp(-decay) * scaled_bessel_i0(node.out.sin * sin_in / (2 * square));
}

}  // namespace

Real scaled_bessel_i0(Real z) {
  if (z < 200) return std::exp(-z) * boost::math::cyl_bessel_i(0, z);
  if (!(z < 1e30L)) return z < INFINITY ? 1 / std::sqrt(2 * pi * z) : 0;
  // Hankel's series: Σ ((2k−1)!!)²/(k! (8z)^k); its terms fall below 1e-20 at z = 200.
  Real term = 1, sum = 1;
  for (int k = 1; k < 30 && term > 1e-22L; ++k) {
    term *= (2 * k - 1) * (2 * k - 1) / (8 * z * k);
    sum += term;
  }
  return sum / std::sqrt(2 * pi * z);
}

std::vector<Real> shadowing_steps(const Width& width) {
  if (!width.shadowing) return {};
  std::vector<Real> steps;
  for (const Real factor : {0.25L, 0.5L, 0.8L, 1.0L, 1.25L, 1.6L, 2.5L, 5.0L, 20.0L})
    steps.push_back(factor * width.w * width.w);
  return steps;
}

Real log_core_integral(Autocovariance autocovariance, const PolarPath& path) {
  if (autocovariance == Autocovariance::gaussian) return std::log(4 * pi) + path.log_square_at_peak();
  // π ∫_{−h}^{h} dx/√(x² + 4 u₀ p²) = 2π asinh(h/2p√u₀), whose argument is over 1e15.
  const Real log_half_width = std::log(2 * path.in().sin) + path.log_square_at_peak() / 2;
  return std::log(2 * pi * (std::log(2 * path.core()) - log_half_width));
}

LogEstimate log_normalization(Autocovariance autocovariance, const Width& width, const Direction& in) {
  const PolarPath path(in, width, shadowing_steps(width));
  const bool gaussian = autocovariance == Autocovariance::gaussian;
  // A Gaussian narrower than the core has nothing outside it.
  if (gaussian && path.core() > 0) return {-log_core_integral(autocovariance, path), integrand_error};

  const Real u_in = in.sin * in.sin;
  const auto integral = integrate<31, 1>(
      [&](int segment, Real x) {
        const PolarNode node = path.node(segment, x);
        const Real ring = gaussian ? gaussian_ring(node, in.sin) : lorentzian_ring(node, u_in);
        return std::array<Real, 1>{ring * node.jacobian};
      },
      path.intervals(), tolerance);
  const Real core = path.core() > 0 ? std::exp(log_core_integral(autocovariance, path)) : 0;
  const Real sum = integral.value[0] + core;
  return {-std::log(sum), integral.error[0] / sum + integrand_error};
}

LogEstimate log_normalization_closed_form(Real rho, const Direction& in) {
  const Real r = rho * rho, u = in.sin * in.sin, v = in.cos * in.cos;
  const Real argument = (v + r + std::sqrt(r * r + 2 * u * r + 2 * r + v * v)) / (2 * r);
  // For wide lobes the argument is 1 + O(ρ⁻²), which costs four of nineteen digits.
  return {-std::log(pi * std::log(argument)), 1e-15L};
}

}  // namespace brdftab::reference

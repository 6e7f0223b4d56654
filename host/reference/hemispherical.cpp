// Directional- and bihemispherical reflectance of the model by nested adaptive
// quadrature: azimuth within θ_s within θ_i.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "host/reference/model.hpp"

namespace brdftab::reference {
namespace {

constexpr Real dhr_tolerance = 1e-12L;
// N at every node makes the reciprocal variant a thousand times dearer.
constexpr Real reciprocal_dhr_tolerance = 1e-10L;
constexpr double bhr_tolerance = 1e-7;

}  // namespace

// sin²θ at which R has a square root, the critical angle sin θ = n, or √R_p a kink,
// Brewster's tan θ = n; with k > 0 these are smooth but may be sharp there.
std::vector<Real> Model::kinks() const {
  const Real modulus = std::norm(index());
  return {std::real(index() * index()), modulus / (1 + modulus)};
}

std::array<Estimate, 2> Model::lobe_dhr(Lobe lobe, const Direction& in) const {
  if (amplitude(lobe) == 0) return {};
  const bool reciprocal = variant_.normalization == Normalization::reciprocal;
  std::vector<Real> breakpoints = shadowing_steps(width(lobe));
  for (const Real kink : kinks()) breakpoints.push_back(kink);
  const PolarPath path(in, width(lobe), breakpoints);
  const AzimuthLobe azimuth{variant_.autocovariance, lobe == Lobe::retro, shadowed(lobe), shadowing(),
                            forward_onset(shadowing(), in)};
  const LogEstimate log_n = log_normalization_at(lobe, in);

  const auto strength = [&](const Direction& out) {
    return lobe == Lobe::surface ? mean_reflectance(index(), in, out) : mean_transmittance(index(), in, out);
  };
  // s, p and the errors that the azimuth integrals add to them.
  const auto integrand = [&](int segment, Real x) -> std::array<Real, 4> {
    const PolarNode node = path.node(segment, x);
    const Polarized amplitudes = strength(node.out);
    if (amplitudes.s == 0 && amplitudes.p == 0) return {};
    const Ring ring = azimuth_integral(azimuth, in, node);
    Real weight = ring.value * node.jacobian;
    if (reciprocal && weight > 0)
      weight *= std::exp((log_normalization_at(lobe, node.out).log - log_n.log) / 2);
    const Real s = amplitudes.s * weight, p = amplitudes.p * weight;
    return {s, p, s * ring.error, p * ring.error};
  };
  // A Gaussian narrower than the core has nothing outside it.
  const bool point = path.core() > 0 && azimuth.autocovariance == Autocovariance::gaussian;
  const auto intervals = point ? std::vector<Interval<Real>>{} : path.intervals();
  const auto integral =
      integrate<15, 4, 2>(integrand, intervals, reciprocal ? reciprocal_dhr_tolerance : dhr_tolerance, 40);
  Real core = 0;
  if (path.core() > 0)
    core = std::exp(log_core_integral(variant_.autocovariance, path) + log_n.log) *
           shadowing_at_peak(azimuth, in);
  const Polarized at_peak = strength(in);
  const auto estimate = [&](int k, Real peak) -> Estimate {
    const Real scale = std::exp(log_n.log);
    const Real outside = integral.value[k] > 0 ? integral.value[k] * scale : 0;
    const Real error = integral.value[k] > 0 ? (integral.error[k] + integral.value[k + 2]) * scale : 0;
    const Real sum = outside + peak * core;
    if (!(sum > 0)) return {static_cast<double>(sum), 0};
    return {static_cast<double>(amplitude(lobe) * sum), static_cast<double>(error / sum + log_n.error)};
  };
  return {estimate(0, at_peak.s), estimate(1, at_peak.p)};
}

Reflectance Model::dhr(const Direction& in) const {
  Reflectance result;
  const auto surface = lobe_dhr(Lobe::surface, in);
  const auto bulk = lobe_dhr(Lobe::bulk, in);
  const auto retro = lobe_dhr(Lobe::retro, in);
  result.s = {surface[0], bulk[0], retro[0]};
  result.p = {surface[1], bulk[1], retro[1]};
  return result;
}

Reflectance Model::dhr(double theta_i) const {
  if (!(theta_i >= 0 && theta_i < 90)) throw std::invalid_argument("polar angle outside [0, 90) degrees");
  return dhr(Direction::from_degrees(theta_i));
}

Reflectance Model::bhr() const {
  constexpr double degree = std::numbers::pi / 180;
  std::vector<double> points{0, 75, 90};
  for (const Real u : kinks())
    if (u > 0 && u < 1) points.push_back(static_cast<double>(std::asin(std::sqrt(u)) / degree));
  std::sort(points.begin(), points.end());
  std::vector<Interval<double>> intervals;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) intervals.push_back({points[i], points[i + 1], 0});
  double inner_error = 0;
  const auto integral = integrate<15, 6>(
      [&](int, double theta) -> std::array<double, 6> {
        const Direction in = Direction::from_degrees(theta);
        const Reflectance r = dhr(in);
        const double weight = static_cast<double>(2 * in.sin * in.cos) * degree;
        const std::array<Estimate, 6> parts{r.s.surface, r.s.bulk, r.s.retro,
                                            r.p.surface, r.p.bulk, r.p.retro};
        std::array<double, 6> values;
        for (std::size_t k = 0; k < 6; ++k) {
          values[k] = weight * parts[k].value;
          inner_error = std::max(inner_error, parts[k].error);
        }
        return values;
      },
      intervals, bhr_tolerance, 12);
  const auto estimate = [&](int k) -> Estimate {
    const double value = integral.value[k];
    return {value, value > 0 ? integral.error[k] / value + inner_error : 0};
  };
  return {{estimate(0), estimate(1), estimate(2)}, {estimate(3), estimate(4), estimate(5)}};
}

}  // namespace brdftab::reference

// f of Eqs. (14), (16) from its factors, and the cache of N.
#include "host/reference/model.hpp"

#include <cmath>
#include <limits>
#include <map>
#include <shared_mutex>
#include <stdexcept>
#include <utility>

namespace brdftab::reference {
namespace {

void require_polar(double theta) {
  if (!(theta >= 0 && theta < 90)) throw std::invalid_argument("polar angle outside [0, 90) degrees");
}

/// factor · e^log, apart because either alone may leave the range of long double.
struct Shape {
  Real log;
  Real factor;
};

double mean(double a, double b) { return (a + b) / 2; }

Estimate mean(const Estimate& a, const Estimate& b) {
  const double sum = a.value + b.value;
  return {sum / 2, sum > 0 ? (a.value * a.error + b.value * b.error) / sum : 0};
}

}  // namespace

Lobes Brdf::unpolarized() const {
  return {mean(s.surface, p.surface), mean(s.bulk, p.bulk), mean(s.retro, p.retro)};
}

Estimate LobeReflectance::total() const {
  const double sum = surface.value + bulk.value + retro.value;
  if (!(sum > 0)) return {sum, 0};
  return {sum, (surface.value * surface.error + bulk.value * bulk.error + retro.value * retro.error) / sum};
}

LobeReflectance Reflectance::unpolarized() const {
  return {mean(s.surface, p.surface), mean(s.bulk, p.bulk), mean(s.retro, p.retro)};
}

struct Model::Cache {
  std::shared_mutex mutex;
  std::map<std::pair<Lobe, double>, LogEstimate> log_normalization;
};

Model::Model(const Parameters& parameters, const Variant& variant)
    : parameters_(parameters), variant_(variant), cache_(std::make_shared<Cache>()) {
  if (variant.normalization == Normalization::closed_form &&
      variant.autocovariance == Autocovariance::gaussian)
    throw std::invalid_argument("the closed form of N, Eq. (8), is of the Lorentzian lobe only");
}

Width Model::width(Lobe lobe) const {
  const double rho = lobe == Lobe::surface ? parameters_.rho_surface
                     : lobe == Lobe::bulk  ? parameters_.rho_bulk
                                           : parameters_.rho_retro;
  return {rho, parameters_.w, parameters_.n, variant_.foreshortening, variant_.width_shadowing};
}

double Model::amplitude(Lobe lobe) const {
  return lobe == Lobe::surface ? parameters_.sigma_surface
         : lobe == Lobe::bulk  ? parameters_.sigma_bulk
                               : parameters_.sigma_retro;
}

bool Model::shadowed(Lobe lobe) const {
  return variant_.reflectance_shadowing == ReflectanceShadowing::all ||
         (variant_.reflectance_shadowing == ReflectanceShadowing::surface && lobe == Lobe::surface);
}

ReflectanceShadowingParameters Model::shadowing() const {
  return {parameters_.w_a, parameters_.w_b, parameters_.gamma, parameters_.delta};
}

LogEstimate Model::log_normalization_at(Lobe lobe, const Direction& in) const {
  if (variant_.normalization == Normalization::closed_form)
    return log_normalization_closed_form(width(lobe).rho, in);
  return log_normalization(variant_.autocovariance, width(lobe), in);
}

LogEstimate Model::cached_log_normalization(Lobe lobe, double theta) const {
  const std::pair key(lobe, theta);
  {
    std::shared_lock lock(cache_->mutex);
    const auto found = cache_->log_normalization.find(key);
    if (found != cache_->log_normalization.end()) return found->second;
  }
  const LogEstimate estimate = log_normalization_at(lobe, Direction::from_degrees(theta));
  std::unique_lock lock(cache_->mutex);
  return cache_->log_normalization.emplace(key, estimate).first->second;
}

LogEstimate Model::pair_log_normalization(Lobe lobe, double theta_i, double theta_s) const {
  const LogEstimate i = cached_log_normalization(lobe, theta_i);
  if (variant_.normalization != Normalization::reciprocal) return i;
  const LogEstimate s = cached_log_normalization(lobe, theta_s);
  return {(i.log + s.log) / 2, (i.error + s.error) / 2};
}

Estimate Model::normalization(Lobe lobe, double theta_i) const {
  require_polar(theta_i);
  const LogEstimate estimate = cached_log_normalization(lobe, theta_i);
  // Rounding of ln N and of the returned double.
  const Real rounding = std::numeric_limits<Real>::epsilon() * std::fabs(estimate.log) + 1.1e-16L;
  return {static_cast<double>(std::exp(estimate.log)), static_cast<double>(estimate.error + rounding)};
}

Brdf Model::brdf(double theta_i, double theta_s, double phi) const {
  require_polar(theta_i);
  require_polar(theta_s);
  if (!std::isfinite(phi)) throw std::invalid_argument("azimuth is not finite");
  const Direction in = Direction::from_degrees(theta_i), out = Direction::from_degrees(theta_s);
  const Polarized g = mean_reflectance(index(), in, out);
  const Polarized t = mean_transmittance(index(), in, out);
  const Real log_v = width(Lobe::surface).log_shadowing(in.sin * in.sin) +
                     width(Lobe::surface).log_shadowing(out.sin * out.sin);

  // Everything but Eqs. (15), (17), (18), which alone depend on polarisation.
  const auto shape = [&](Lobe lobe) -> Shape {
    const Real distance = lobe == Lobe::retro ? squared_distance_retro(theta_i, theta_s, phi)
                                              : squared_distance(theta_i, theta_s, phi);
    const Real log_square = width(lobe).log_square(in.cos, out.cos, log_v, 0);
    Real log_scale = pair_log_normalization(lobe, theta_i, theta_s).log;
    Real v_m = 1;
    if (shadowed(lobe)) {
      v_m = reflectance_shadowing(shadowing(), in, out, phi);
      if (v_m < std::numeric_limits<Real>::min()) {
        log_scale += log_reflectance_shadowing(shadowing(), in, out, phi);
        v_m = 1;
      }
    }
    if (variant_.autocovariance == Autocovariance::gaussian)
      return {distance == 0 ? log_scale : log_scale - distance * std::exp(-log_square) / 4, v_m};
    const Real denominator = distance + std::exp(log_square);
    // Where ρ′² underflows too, at the centre of a lobe, only its logarithm is left.
    if (denominator < std::numeric_limits<Real>::min()) return {log_scale - log_square, v_m};
    return {log_scale, v_m / denominator};
  };
  const std::array<Shape, 3> shapes{shape(Lobe::surface), shape(Lobe::bulk), shape(Lobe::retro)};
  const auto value = [](Real strength, const Shape& lobe) -> double {
    // Exactly no light, also where the lobe itself is infinite.
    return strength == 0 ? 0 : static_cast<double>(std::exp(lobe.log + std::log(strength)) * lobe.factor);
  };
  const auto lobes = [&](Real g_polarized, Real t_polarized) {
    return Lobes{value(parameters_.sigma_surface * g_polarized, shapes[0]),
                 value(parameters_.sigma_bulk * t_polarized, shapes[1]),
                 value(parameters_.sigma_retro * t_polarized, shapes[2])};
  };
  return {lobes(g.s, t.s), lobes(g.p, t.p)};
}

}  // namespace brdftab::reference

// Eq. (15) with c = m √(1 − sin²θ/m²) = √(m² − sin²θ), m the complex index. The
// amplitudes are brought to the forms whose numerators are products, which have
// no cancellation near m = 1, near Brewster's angle or near the critical angle.
#include "host/reference/fresnel.hpp"

#include <cmath>

namespace brdftab::reference {
namespace {

using Complex = std::complex<Real>;

Complex contrast(Complex m) { return (m - Real(1)) * (m + Real(1)); }

// m² − sin²θ = (m² − 1) + μ², whichever leaves less to cancel.
Complex refracted(Complex m, const Direction& direction) {
  const Real mu = direction.cos;
  if (mu < direction.sin) return std::sqrt(contrast(m) + mu * mu);
  return std::sqrt((m - direction.sin) * (m + direction.sin));
}

}  // namespace

Polarized reflectance(Complex m, const Direction& direction) {
  const Real mu = direction.cos;
  const Complex c = refracted(m, direction);
  // (μ − c)(μ + c) = 1 − m²;  (m²μ − c)(m²μ + c) = (m² − 1)(mμ − sin θ)(mμ + sin θ).
  const Complex s = contrast(m) / ((mu + c) * (mu + c));
  const Complex denominator = m * m * mu + c;
  const Complex p =
      contrast(m) * (m * mu - direction.sin) * (m * mu + direction.sin) / (denominator * denominator);
  return {std::norm(s), std::norm(p)};
}

Polarized transmittance(Complex m, const Direction& direction) {
  const Real mu = direction.cos;
  const Complex c = refracted(m, direction);
  // 1 − |a − b|²/|a + b|² = 4 Re(a b*)/|a + b|².  For p, a = m²μ, b = c and
  // Re(m² c*) = Re(c) (|c|² + sin²θ), because m² = c² + sin²θ.
  const Real s = 4 * mu * c.real() / std::norm(mu + c);
  const Real p =
      4 * mu * c.real() * (std::norm(c) + direction.sin * direction.sin) / std::norm(m * m * mu + c);
  return {s, p};
}

Polarized mean_reflectance(Complex m, const Direction& in, const Direction& out) {
  const Polarized i = reflectance(m, in), s = reflectance(m, out);
  return {std::sqrt(i.s) * std::sqrt(s.s), std::sqrt(i.p) * std::sqrt(s.p)};
}

Polarized mean_transmittance(Complex m, const Direction& in, const Direction& out) {
  const Polarized g = mean_reflectance(m, in, out);
  const Polarized i = transmittance(m, in), s = transmittance(m, out);
  // T_s + T_i (1 − T_s) keeps its digits when T_s is near 1, since R_s does.
  const Polarized r = reflectance(m, out);
  return {(s.s + i.s * r.s) / (1 + g.s), (s.p + i.p * r.p) / (1 + g.p)};
}

}  // namespace brdftab::reference

// V by Boost's regularised incomplete gamma function, by a continued fraction
// of its logarithm where the function itself underflows.
#include "host/reference/width_shadowing.hpp"

#include <boost/math/special_functions/gamma.hpp>

#include <cmath>
#include <limits>

namespace brdftab::reference {
namespace {

using Policy = boost::math::policies::policy<boost::math::policies::promote_double<false>>;

// ln Q(a, x) for x well above a: x^a e^-x / Γ(a) times Legendre's continued
// fraction 1/(x+1−a− 1(1−a)/(x+3−a− …)), by Lentz's method.
Real log_gamma_q_tail(Real a, Real x) {
  Real b = x + 1 - a;
  Real c = 1 / std::numeric_limits<Real>::min();
  Real d = 1 / b;
  Real fraction = d;
  for (int i = 1; i < 10000; ++i) {
    const Real numerator = i * (a - i);
    b += 2;
    d = 1 / (numerator * d + b);
    c = b + numerator / c;
    const Real factor = c * d;
    fraction *= factor;
    if (std::fabs(factor - 1) < std::numeric_limits<Real>::epsilon()) break;
  }
  return a * std::log(x) - x - boost::math::lgamma(a, Policy()) + std::log(fraction);
}

}  // namespace

Real log_width_shadowing(Real chi_squared, Real w, Real n) {
  const Real a = 1 + n;
  const Real x = a * (chi_squared / (w * w));
  if (n == 0) return -x;  // Eq. (11)
  // Far out the fraction needs only tens of terms and loses no relative digits.
  if (x > 2 * a + 40) return log_gamma_q_tail(a, x);
  return std::log(boost::math::gamma_q(a, x, Policy()));
}

Real width_shadowing(Real chi_squared, Real w, Real n) {
  return std::exp(log_width_shadowing(chi_squared, w, n));
}

Real Width::log_shadowing(Real chi_squared) const {
  return shadowing ? log_width_shadowing(chi_squared, w, n) : 0;
}

Real Width::log_square(const Direction& in, const Direction& out) const {
  return log_square(in.cos, out.cos, log_shadowing(in.sin * in.sin), log_shadowing(out.sin * out.sin));
}

Real Width::log_square(Real mu_i, Real mu_s, Real log_shadowing_i, Real log_shadowing_s) const {
  const Real width = foreshortening ? rho * (mu_i + mu_s) / 2 : rho;
  return 2 * std::log(width) + log_shadowing_i + log_shadowing_s;
}

}  // namespace brdftab::reference

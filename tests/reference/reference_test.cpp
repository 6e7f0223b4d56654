// Rung 0, the factors: equations, limits and identities of the paper against the
// scalar reference's directions, Fresnel, V and V_m.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "host/reference/direction.hpp"
#include "host/reference/fresnel.hpp"
#include "host/reference/reflectance_shadowing.hpp"
#include "host/reference/width_shadowing.hpp"

namespace brdftab::reference {
namespace {

using Complex = std::complex<Real>;

// Both sides are long double, and differ by some tens of its ulp of 1e-19.
constexpr Real rounding = 1e-17L;

Real relative_difference(Real a, Real b) { return a == b ? 0 : std::fabs(a - b) / std::fabs(b); }

// Eq. (15) as printed.
Polarized equation_15(Complex m, const Direction& d) {
  const Complex root = std::sqrt(Real(1) - d.sin * d.sin / (m * m));
  return {std::norm((d.cos - m * root) / (d.cos + m * root)),
          std::norm((-m * d.cos + root) / (m * d.cos + root))};
}

TEST(ReferenceDirection, IsExactWhereItCanBe) {
  EXPECT_EQ(cos_degrees(90), 0);
  EXPECT_EQ(cos_degrees(-270), 0);
  EXPECT_EQ(sin_degrees(180), 0);
  EXPECT_EQ(sin_degrees(30), 0.5L);
  EXPECT_EQ(sin_degrees(-150), -0.5L);
  EXPECT_EQ(cos_degrees(240), -0.5L);
  EXPECT_EQ(cos_degrees(0), 1);
}

TEST(ReferenceDirection, KeepsDigitsNearGrazing) {
  const double theta = 89.9;
  const Real x = (90 - Real(theta)) * std::numbers::pi_v<Real> / 180;
  const Real series = x - x * x * x / 6 + std::pow(x, 5.0L) / 120;
  EXPECT_LT(relative_difference(Direction::from_degrees(theta).cos, series), rounding);
}

TEST(ReferenceDistance, IsTheDistanceOfDirectionVectors) {
  for (const double i : {0.0, 12.5, 89.9})
    for (const double s : {0.0, 33.0, 89.0})
      for (const double phi : {0.0, 77.0, 180.0, -260.0}) {
        const Real alpha = sin_degrees(s) * cos_degrees(phi), beta = -sin_degrees(s) * sin_degrees(phi);
        const Real forward = std::pow(alpha - sin_degrees(i), 2) + beta * beta;
        const Real retro = std::pow(alpha + sin_degrees(i), 2) + beta * beta;
        // The tolerance is absolute: the vectors, not the distance, cancel at a centre.
        EXPECT_NEAR(double(squared_distance(i, s, phi)), double(forward), 1e-18)
            << i << ' ' << s << ' ' << phi;
        EXPECT_NEAR(double(squared_distance_retro(i, s, phi)), double(retro), 1e-18)
            << i << ' ' << s << ' ' << phi;
      }
}

TEST(ReferenceDistance, KeepsDigitsAtThePeak) {
  // To second order d² is (cos θ Δθ)² + (sin θ Δφ)²; the next term is 1e-8 of it.
  const Real step = 0x1p-20L * std::numbers::pi_v<Real> / 180;
  const Real in_plane = std::pow(cos_degrees(60) * step, 2), across = std::pow(sin_degrees(60) * step, 2);
  constexpr Real second_order = 1e-7L;
  EXPECT_LT(relative_difference(squared_distance(60, 60 + 0x1p-20, 0), in_plane), second_order);
  EXPECT_LT(relative_difference(squared_distance(60, 60, 0x1p-20), across), second_order);
  EXPECT_LT(relative_difference(squared_distance_retro(60, 60, 180 + 0x1p-20), across), second_order);
  EXPECT_EQ(squared_distance(60, 60, 0), 0);
  EXPECT_EQ(squared_distance_retro(60, 60, 180), 0);
}

TEST(ReferenceFresnel, IsEquation15) {
  for (const Complex m :
       {Complex(1.5L, 0), Complex(0.78L, 0.14L), Complex(0.05L, 20), Complex(20, 20), Complex(0.65L, 0)})
    for (const double theta : {0.0, 20.0, 55.0, 80.0, 89.9}) {
      const Direction d = Direction::from_degrees(theta);
      const Polarized r = reflectance(m, d), expected = equation_15(m, d);
      // The printed form cancels to an absolute error of an ulp.
      EXPECT_NEAR(double(r.s), double(expected.s), 1e-16) << m << " theta " << theta;
      EXPECT_NEAR(double(r.p), double(expected.p), 1e-16) << m << " theta " << theta;
    }
}

TEST(ReferenceFresnel, NormalIncidence) {
  for (const Real n : {0.05L, 0.78L, 1.5L, 20.0L})
    for (const Real k : {0.0L, 0.14L, 20.0L}) {
      const Polarized r = reflectance({n, k}, Direction::from_degrees(0));
      const Real expected = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
      EXPECT_LT(relative_difference(r.s, expected), rounding) << n << ' ' << k;
      EXPECT_LT(relative_difference(r.p, expected), rounding) << n << ' ' << k;
    }
}

TEST(ReferenceFresnel, Brewster) {
  for (const Real n : {0.7L, 1.24L, 4.7L}) {
    const Real h = std::hypot(1.0L, n);
    const Direction brewster{n / h, 1 / h};
    EXPECT_LT(reflectance({n, 0}, brewster).p, 1e-36L) << n;
    EXPECT_GT(reflectance({n, 0}, brewster).s, 1e-3L) << n;
    EXPECT_NEAR(double(transmittance({n, 0}, brewster).p), 1, 1e-16) << n;
  }
}

TEST(ReferenceFresnel, EnergyIsConserved) {
  for (const Real n : {0.05L, 0.65L, 1.0L, 1.5L, 20.0L})
    for (const Real k : {0.0L, 1e-6L, 0.3L, 1.0L, 20.0L})
      for (const double theta : {0.0, 40.0, 75.0, 89.9}) {
        const Direction d = Direction::from_degrees(theta);
        const Polarized r = reflectance({n, k}, d), t = transmittance({n, k}, d);
        EXPECT_NEAR(double(r.s + t.s), 1, 1e-15) << n << ' ' << k << " theta " << theta;
        EXPECT_NEAR(double(r.p + t.p), 1, 1e-15) << n << ' ' << k << " theta " << theta;
        EXPECT_GE(t.s, 0) << n << ' ' << k << " theta " << theta;
      }
}

TEST(ReferenceFresnel, NothingPassesBeyondTheCriticalAngle) {
  const Complex half(0.5L, 0);
  for (const double theta : {30.0, 30.0001, 60.0, 89.9}) {
    const Polarized t = transmittance(half, Direction::from_degrees(theta));
    EXPECT_EQ(t.s, 0) << theta;
    EXPECT_EQ(t.p, 0) << theta;
  }
  EXPECT_GT(transmittance(half, Direction::from_degrees(29.9999)).s, 0);
  const Polarized both = mean_transmittance(half, Direction::from_degrees(50), Direction::from_degrees(80));
  EXPECT_EQ(both.s, 0);
  EXPECT_EQ(both.p, 0);
}

TEST(ReferenceFresnel, AnIndexOfOneReflectsNothing) {
  const Direction d = Direction::from_degrees(70), e = Direction::from_degrees(89.9);
  EXPECT_EQ(reflectance({1, 0}, d).s, 0);
  EXPECT_EQ(reflectance({1, 0}, d).p, 0);
  EXPECT_LT(std::fabs(mean_transmittance({1, 0}, d, e).s - 1), rounding);
  // To first order in n − 1, R_s is ((n − 1)/2μ²)².
  const Real step = 0x1p-40L;
  const Real expected = std::pow(step / (2 * d.cos * d.cos), 2);
  EXPECT_LT(relative_difference(reflectance({1 + step, 0}, d).s, expected), 1e-9L);
}

TEST(ReferenceFresnel, MeanTransmittanceIsOneMinusMeanReflectance) {
  for (const Complex m : {Complex(1.5L, 0), Complex(0.05L, 20), Complex(2.5L, 1.3L)}) {
    const Direction i = Direction::from_degrees(89.9), s = Direction::from_degrees(89.8);
    const Polarized g = mean_reflectance(m, i, s), t = mean_transmittance(m, i, s);
    EXPECT_NEAR(double(g.s + t.s), 1, 1e-15) << m;
    EXPECT_NEAR(double(g.p + t.p), 1, 1e-15) << m;
    // T_s = 4 μ Re √(m² − sin²θ)/|…|², so 1 − g is the mean of the two T to first order.
    const Real mean = (transmittance(m, i).s + transmittance(m, s).s) / 2;
    EXPECT_LT(relative_difference(t.s, mean), 0.02L) << m;
  }
}

TEST(ReferenceWidthShadowing, Equation11) {
  for (const double theta : {0.0, 30.0, 89.9}) {
    const Real chi_squared = std::pow(sin_degrees(theta), 2);
    for (const Real w : {0.05L, 0.9L, 100.0L})
      EXPECT_LT(relative_difference(width_shadowing(chi_squared, w, 0), std::exp(-chi_squared / (w * w))),
                1e-16L)
          << theta << ' ' << w;
  }
}

TEST(ReferenceWidthShadowing, IntegerFlatnessIsAPoissonSum) {
  // Q(1 + n, x) = e^−x Σ_{k ≤ n} x^k/k!, in logarithms as V falls to e^-24400.
  for (const int n : {1, 2, 7, 30, 60})
    for (const Real w : {0.05L, 0.1L, 0.3L, 0.93L, 2.0L, 100.0L})
      for (const double theta : {0.01, 3.0, 20.0, 60.0, 89.9}) {
        const Real chi_squared = std::pow(sin_degrees(theta), 2);
        const Real x = (1 + n) * chi_squared / (w * w);
        Real sum = 1;  // Σ x^k/k! / (x^n/n!), from the last term
        Real term = 1;
        for (int k = n; k > 0; --k) sum += term *= k / x;
        const Real log_v = -x + n * std::log(x) - std::lgamma(Real(n + 1)) + std::log(sum);
        // An absolute error of ln V is a relative one of V; x itself carries an ulp of up to 24400.
        EXPECT_NEAR(double(log_width_shadowing(chi_squared, w, n) - log_v), 0, 1e-17 * double(x) + 1e-16)
            << "n " << n << " w " << double(w) << " theta " << theta << " ln V " << double(log_v);
      }
}

TEST(ReferenceWidthShadowing, IsContinuousInFlatness) {
  const Real v = log_width_shadowing(0.6L, 0.5L, 12), next = log_width_shadowing(0.6L, 0.5L, 12 + 1e-9L);
  EXPECT_NE(v, next);
  EXPECT_NEAR(double(v), double(next), 1e-7);
}

TEST(ReferenceWidthShadowing, WidthOfEquation12) {
  const Direction i = Direction::from_degrees(60), s = Direction::from_degrees(0);
  const Width on{0.2L, 0.9L, 3, true, true}, off{0.2L, 0.9L, 3, false, false};
  const Real v = width_shadowing(0.75L, 0.9L, 3);
  EXPECT_LT(relative_difference(std::exp(on.log_square(i, s)), 0.25L * 0.04L * 2.25L * v), 1e-16L);
  EXPECT_LT(relative_difference(std::exp(off.log_square(i, s)), 0.04L), 1e-16L);
}

constexpr ReflectanceShadowingParameters shadowing{0.4L, 0.3L, 5, 0.7L};

// Eq. (13) as printed, with Sgn.
Real equation_13(const ReflectanceShadowingParameters& q, const Direction& in, const Direction& out,
                 double phi) {
  const Real alpha = out.sin * cos_degrees(phi), zeta = alpha / std::sqrt(1 - alpha * alpha);
  const Real zeta_0 = in.sin / in.cos, sign = zeta > 0 ? 1 : zeta < 0 ? -1 : 0;
  const Real onset = std::exp(-q.gamma * std::fabs(zeta_0) * std::exp(-q.delta / (zeta_0 * zeta_0)));
  return 0.5L * (1 - onset) * (sign + 1) +
         std::exp(-q.w_a * std::fabs(zeta) * std::exp(-q.w_b / (alpha * alpha))) *
             (0.5L * (1 - sign) + 0.5L * onset * (sign + 1));
}

TEST(ReferenceReflectanceShadowing, IsEquation13) {
  for (const double i : {5.0, 45.0, 85.0})
    for (const double s : {10.0, 60.0, 89.0})
      for (const double phi : {0.0, 40.0, 89.0, 91.0, 180.0, 300.0}) {
        const Direction in = Direction::from_degrees(i), out = Direction::from_degrees(s);
        const Real v_m = reflectance_shadowing(shadowing, in, out, phi);
        // 1 − α² as printed loses four digits at 89°.
        EXPECT_LT(relative_difference(v_m, equation_13(shadowing, in, out, phi)), 1e-14L)
            << i << ' ' << s << ' ' << phi;
        EXPECT_NEAR(double(std::exp(log_reflectance_shadowing(shadowing, in, out, phi)) - v_m), 0, 1e-17)
            << i << ' ' << s << ' ' << phi;
      }
}

TEST(ReferenceReflectanceShadowing, IsOneAtAlphaZeroAndFromBothSides) {
  ReflectanceShadowingParameters sharp = shadowing;
  sharp.w_b = 0;
  const Direction in = Direction::from_degrees(70), out = Direction::from_degrees(50);
  EXPECT_EQ(reflectance_shadowing(sharp, in, out, 90), 1);
  EXPECT_EQ(reflectance_shadowing(sharp, in, Direction::from_degrees(0), 0), 1);
  for (const double phi : {90 - 1e-6, 90 + 1e-6}) {
    const Real v_m = reflectance_shadowing(sharp, in, out, phi);
    EXPECT_LT(v_m, 1) << phi;
    EXPECT_GT(v_m, 1 - 1e-7L) << phi;
  }
}

TEST(ReferenceReflectanceShadowing, OneSidedLimits) {
  const Direction normal = Direction::from_degrees(0), out = Direction::from_degrees(80);
  // At α₀ = 0, E₀ = 1 and V_m is even in α.
  EXPECT_EQ(reflectance_shadowing(shadowing, normal, out, 0),
            reflectance_shadowing(shadowing, normal, out, 180));
  // Large γ lights the forward side fully and leaves the other as it is.
  ReflectanceShadowingParameters lit = shadowing;
  lit.gamma = 1000;
  lit.delta = 0;
  const Direction grazing = Direction::from_degrees(80);
  EXPECT_EQ(reflectance_shadowing(lit, grazing, out, 0), 1);
  EXPECT_EQ(reflectance_shadowing(lit, grazing, out, 180),
            reflectance_shadowing(shadowing, grazing, out, 180));
}

}  // namespace
}  // namespace brdftab::reference

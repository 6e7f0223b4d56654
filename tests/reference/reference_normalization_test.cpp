// Rung 0, N: closed forms, symmetry and brute-force integrals over the disc against
// the scalar reference's quadrature.
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/reference/model.hpp"

namespace brdftab::reference {
namespace {

// The reference has to reach this, since kernels are judged by it at 1e-10.
constexpr double normalization_tolerance = 1e-12;
// The products of Gauss panels below reach this.
constexpr double brute_force_tolerance = 1e-9;

Parameters parameters() {
  return {.n_eff = 1.3,
          .k_eff = 0.2,
          .sigma_surface = 0.7,
          .rho_surface = 0.3,
          .sigma_bulk = 0.2,
          .rho_bulk = 0.8,
          .sigma_retro = 0.1,
          .rho_retro = 0.3,
          .w_a = 0.3,
          .w_b = 0.5,
          .gamma = 4,
          .delta = 0.6,
          .w = 0.9,
          .n = 3.5};
}

// Eq. (8) in the form that gives N as printed.
double equation_8(double rho, double theta_i) {
  const Real s = std::pow(sin_degrees(theta_i), 2), r = Real(rho) * rho;
  const Real root = std::sqrt(r * r + 2 * s * r + 2 * r + (1 - s) * (1 - s));
  return static_cast<double>(1 / (std::numbers::pi_v<Real> * std::log((-s + r + root + 1) / (2 * r))));
}

// ∬ over the disc of direction cosines of what f does with φ, by 30-point panels
// that are graded towards the mirror direction.
template <class Function>
double brute_force(const Function& f, double theta_i) {
  using Gauss = boost::math::quadrature::gauss<double, 30>;
  constexpr double radian = std::numbers::pi / 180;
  double sum = 0;
  std::vector<double> thetas{0, theta_i / 2, theta_i, (theta_i + 90) / 2, 80, 88, 89.5, 90};
  for (double d = 20; d > 0.1; d /= 3) {
    thetas.push_back(std::max(0.0, theta_i - d));
    thetas.push_back(std::min(90.0, theta_i + d));
  }
  std::sort(thetas.begin(), thetas.end());
  for (std::size_t i = 0; i + 1 < thetas.size(); ++i) {
    if (thetas[i + 1] - thetas[i] < 1e-9) continue;
    sum += Gauss::integrate(
        [&](double theta) {
          double ring = 0;
          for (double begin = 180, end; begin > 1; begin = end) {
            end = begin > 3 ? begin / 3 : 0;
            ring += Gauss::integrate([&](double phi) { return f(theta, phi); }, end, begin);
          }
          return 2 * ring * radian * double(sin_degrees(theta) * cos_degrees(theta)) * radian;
        },
        thetas[i], thetas[i + 1]);
  }
  return sum;
}

TEST(ReferenceNormalization, Equation8WithForeshorteningAndVOff) {
  Parameters p = parameters();
  const Variant flat{.foreshortening = false, .width_shadowing = false};
  Variant closed = flat;
  closed.normalization = Normalization::closed_form;
  for (const double rho : {1e-4, 0.01, 0.5, 3.0, 100.0}) {
    p.rho_bulk = rho;
    for (const double theta : {0.0, 1e-3, 30.0, 75.0, 89.9}) {
      const Estimate numeric = Model(p, flat).normalization(Lobe::bulk, theta);
      const Estimate analytic = Model(p, closed).normalization(Lobe::bulk, theta);
      EXPECT_NEAR(numeric.value / equation_8(rho, theta), 1, normalization_tolerance)
          << rho << " theta_i " << theta;
      EXPECT_NEAR(analytic.value / equation_8(rho, theta), 1, normalization_tolerance)
          << rho << " theta_i " << theta;
      EXPECT_LT(numeric.error, normalization_tolerance);
      EXPECT_GT(numeric.error, 0);
    }
  }
}

TEST(ReferenceNormalization, ClosedFormKeepsRhoConstant) {
  Variant closed{.normalization = Normalization::closed_form};
  EXPECT_NEAR(Model(parameters(), closed).normalization(Lobe::bulk, 50).value / equation_8(0.8, 50), 1,
              normalization_tolerance);
  closed.autocovariance = Autocovariance::gaussian;
  EXPECT_THROW(Model(parameters(), closed), std::invalid_argument);
}

TEST(ReferenceNormalization, NormalIncidenceWithVOffIsElementary) {
  // At α₀ = 0, D = s² + ¼ρ²(1 + μ)² and ∬ dα dβ/D = 2π ∫ μ dμ/(…), rational in μ:
  // for ρ = 2, D = 2(1 + μ), and 2π ∫₀¹ μ/(2 + 2μ) dμ = π (1 − ln 2).
  Parameters p = parameters();
  p.rho_bulk = 2;
  const Model model(p, {.width_shadowing = false});
  EXPECT_NEAR(model.normalization(Lobe::bulk, 0).value * std::numbers::pi * (1 - std::numbers::ln2), 1,
              normalization_tolerance);
}

TEST(ReferenceNormalization, IsTheSameAtPlusAndMinusAlpha0) {
  const Model model(parameters());
  for (const double theta : {0.0, 40.0, 89.9})
    EXPECT_EQ(model.normalization(Lobe::surface, theta).value, model.normalization(Lobe::retro, theta).value);
  EXPECT_NE(model.normalization(Lobe::surface, 40).value, model.normalization(Lobe::bulk, 40).value);
}

// The lobe of Eq. (12) or (2) from its factors, without N.
double bare_lobe(const Parameters& p, Autocovariance autocovariance, double theta_i, double theta_s,
                 double phi) {
  const Width width{p.rho_bulk, p.w, p.n, true, true};
  const Real square =
      std::exp(width.log_square(Direction::from_degrees(theta_i), Direction::from_degrees(theta_s)));
  const Real distance = squared_distance(theta_i, theta_s, phi);
  return static_cast<double>(autocovariance == Autocovariance::gaussian ? std::exp(-distance / (4 * square))
                                                                        : 1 / (distance + square));
}

TEST(ReferenceNormalization, LobesIntegrateToOne) {
  Parameters p = parameters();
  for (const auto autocovariance : {Autocovariance::lorentzian, Autocovariance::gaussian})
    for (const double rho : {0.3, 0.8, 20.0})
      for (const double theta : {0.0, 25.0, 60.0}) {
        p.rho_bulk = rho;
        const Model model(p, {.autocovariance = autocovariance});
        const double integral = brute_force(
            [&](double theta_s, double phi) { return bare_lobe(p, autocovariance, theta, theta_s, phi); },
            theta);
        EXPECT_NEAR(integral * model.normalization(Lobe::bulk, theta).value, 1, brute_force_tolerance)
            << "gaussian " << (autocovariance == Autocovariance::gaussian) << " rho " << rho << " theta_i "
            << theta;
      }
}

TEST(ReferenceNormalization, DependsOnVOnlyLogarithmicallyWhereVVanishes) {
  // With ln ρ′² → −∞ the lobe is a point: ∬ dα dβ/D → π ln((1 − α₀²)²/(α₀² ρ′²)) + …, the
  // limit of Eq. (6); here ln ρ′² = −2 · 12000 and the rest, ln 9, is 1e-4 of it.
  Parameters p = parameters();
  p.w = 0.05;
  p.n = 60;
  const Model model(p);
  for (const double theta : {30.0, 45.0, 60.0, 89.9}) {
    const Direction in = Direction::from_degrees(theta);
    const Width width{p.rho_bulk, p.w, p.n, true, true};
    // Outside the peak 1/N has ∫ du/|u − u₀| only, whatever V does there.
    const Real u = in.sin * in.sin, v = in.cos * in.cos;
    const Real limit =
        std::numbers::pi_v<Real> * (std::log(u) + std::log(v) - std::log(u) - width.log_square(in, in));
    const Estimate n = model.normalization(Lobe::bulk, theta);
    EXPECT_NEAR(n.value * static_cast<double>(limit), 1, normalization_tolerance) << theta;
    EXPECT_LT(n.error, normalization_tolerance) << theta;
  }
}

TEST(ReferenceNormalization, GaussianTooNarrowForADoubleIsInfinite) {
  Parameters p = parameters();
  p.w = 0.05;
  p.n = 60;
  EXPECT_TRUE(
      std::isinf(Model(p, {.autocovariance = Autocovariance::gaussian}).normalization(Lobe::bulk, 60).value));
}

TEST(ReferenceNormalization, NarrowGaussianIsAPlaneIntegral) {
  // ∬ exp(−d²/4ρ²) over the plane is 4πρ²; the disc's edge is e^-9000 away.
  Parameters p = parameters();
  p.rho_bulk = 1e-3;
  const Model model(
      p, {.autocovariance = Autocovariance::gaussian, .foreshortening = false, .width_shadowing = false});
  EXPECT_NEAR(model.normalization(Lobe::bulk, 50).value * 4 * std::numbers::pi * 1e-6, 1,
              normalization_tolerance);
}

}  // namespace
}  // namespace brdftab::reference

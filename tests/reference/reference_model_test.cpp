// Rung 0, the composed model: symmetries, limits and hemispherical integrals of f.
#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <thread>

#include "host/reference/model.hpp"

namespace brdftab::reference {
namespace {

// f is rounded to double from long double.
constexpr double rounding = 1e-15;
constexpr double dhr_tolerance = 1e-9;

Parameters parameters() {
  return {.n_eff = 0.78,
          .k_eff = 0.14,
          .sigma_surface = 0.7,
          .rho_surface = 0.3,
          .sigma_bulk = 0.2,
          .rho_bulk = 0.8,
          .sigma_retro = 0.1,
          .rho_retro = 0.4,
          .w_a = 0.3,
          .w_b = 0.5,
          .gamma = 4,
          .delta = 0.6,
          .w = 0.9,
          .n = 3.5};
}

constexpr double thetas[] = {0, 17, 63.5, 89.9};
constexpr double azimuths[] = {0, 1e-6, 33, 90, 140, 180};

TEST(ReferenceModel, IsEquation14) {
  const Parameters p = parameters();
  const Model model(p);
  const double i = 50, s = 35, phi = 70;
  const Direction in = Direction::from_degrees(i), out = Direction::from_degrees(s);
  const Real alpha_0 = in.sin, alpha = out.sin * cos_degrees(phi), beta = -out.sin * sin_degrees(phi);
  const Real v = width_shadowing(in.sin * in.sin, p.w, p.n) * width_shadowing(out.sin * out.sin, p.w, p.n);
  const auto denominator = [&](Real centre, Real rho) {
    return std::pow(alpha - centre, 2) + beta * beta + std::pow(in.cos + out.cos, 2) / 4 * v * rho * rho;
  };
  const Real v_m = reflectance_shadowing({p.w_a, p.w_b, p.gamma, p.delta}, in, out, phi);
  const Real g = mean_reflectance({p.n_eff, p.k_eff}, in, out).s;
  const auto n = [&](Lobe lobe) { return model.normalization(lobe, i).value; };
  const Brdf f = model.brdf(i, s, phi);
  EXPECT_NEAR(f.s.surface /
                  double(p.sigma_surface * g * v_m * n(Lobe::surface) / denominator(alpha_0, p.rho_surface)),
              1, rounding);
  EXPECT_NEAR(
      f.s.bulk / double(p.sigma_bulk * (1 - g) * v_m * n(Lobe::bulk) / denominator(alpha_0, p.rho_bulk)), 1,
      rounding);
  EXPECT_NEAR(
      f.s.retro / double(p.sigma_retro * (1 - g) * v_m * n(Lobe::retro) / denominator(-alpha_0, p.rho_retro)),
      1, rounding);
  EXPECT_NE(f.s.surface, f.p.surface);
  EXPECT_EQ(f.unpolarized().bulk, (f.s.bulk + f.p.bulk) / 2);
}

TEST(ReferenceModel, IsEvenInPhiPeriodicAndNotNegative) {
  const Model model(parameters());
  for (const double i : thetas)
    for (const double s : thetas)
      for (const double phi : azimuths) {
        const double f = model.brdf(i, s, phi).unpolarized().total();
        EXPECT_GE(f, 0) << i << ' ' << s << ' ' << phi;
        EXPECT_EQ(f, model.brdf(i, s, -phi).unpolarized().total()) << i << ' ' << s << ' ' << phi;
        EXPECT_NEAR(model.brdf(i, s, 360 - phi).unpolarized().total() / f, 1, 1e-9)
            << i << ' ' << s << ' ' << phi;
      }
}

TEST(ReferenceModel, ReciprocalNormalizationWithoutVmIsReciprocal) {
  Variant variant{.normalization = Normalization::reciprocal,
                  .reflectance_shadowing = ReflectanceShadowing::none};
  const Model reciprocal(parameters(), variant);
  variant.normalization = Normalization::hemispherical;
  const Model hemispherical(parameters(), variant);
  for (const double phi : azimuths) {
    const double a = reciprocal.brdf(20, 75, phi).unpolarized().total();
    const double b = reciprocal.brdf(75, 20, phi).unpolarized().total();
    EXPECT_NEAR(a / b, 1, rounding) << "20 75 " << phi << ": " << a << ' ' << b;
    EXPECT_GT(std::fabs(hemispherical.brdf(20, 75, phi).unpolarized().total() /
                            hemispherical.brdf(75, 20, phi).unpolarized().total() -
                        1),
              1e-3);
  }
  EXPECT_EQ(reciprocal.brdf(40, 40, 10).s.bulk, hemispherical.brdf(40, 40, 10).s.bulk);
}

TEST(ReferenceModel, SwitchesActOnTheirFactor) {
  const Parameters p = parameters();
  const double i = 60, s = 70, phi = 150;
  const Brdf all = Model(p).brdf(i, s, phi);
  const Brdf none = Model(p, {.reflectance_shadowing = ReflectanceShadowing::none}).brdf(i, s, phi);
  const Brdf surface = Model(p, {.reflectance_shadowing = ReflectanceShadowing::surface}).brdf(i, s, phi);
  const double v_m = double(reflectance_shadowing(
      {p.w_a, p.w_b, p.gamma, p.delta}, Direction::from_degrees(i), Direction::from_degrees(s), phi));
  ASSERT_LT(v_m, 0.9);
  EXPECT_NEAR(all.s.retro / none.s.retro, v_m, rounding);
  EXPECT_EQ(surface.s.surface, all.s.surface);
  EXPECT_EQ(surface.s.retro, none.s.retro);
  // A Gaussian lobe at its centre is N; a Lorentzian is N/ρ′².
  const Model gaussian(
      p, {.autocovariance = Autocovariance::gaussian, .reflectance_shadowing = ReflectanceShadowing::none});
  const Real g =
      mean_transmittance({p.n_eff, p.k_eff}, Direction::from_degrees(i), Direction::from_degrees(i)).s;
  EXPECT_NEAR(gaussian.brdf(i, i, 180).s.retro /
                  double(p.sigma_retro * g * gaussian.normalization(Lobe::retro, i).value),
              1, rounding);
}

TEST(ReferenceModel, TotalReflectionLeavesTheSurfaceOnly) {
  Parameters p = parameters();
  p.n_eff = 0.5;
  p.k_eff = 0;
  const Brdf f = Model(p).brdf(30, 45, 20);
  EXPECT_EQ(f.s.bulk, 0);
  EXPECT_EQ(f.p.retro, 0);
  EXPECT_GT(f.s.surface, 0);
  EXPECT_GT(Model(p).brdf(29, 45, 20).s.bulk, 0);
}

TEST(ReferenceModel, OverflowIsInfiniteAndDarknessZero) {
  Parameters p = parameters();
  p.w = 0.05;
  p.n = 60;
  EXPECT_TRUE(std::isinf(Model(p).brdf(60, 60, 0).s.bulk));
  EXPECT_TRUE(std::isfinite(Model(p).brdf(60, 60, 1e-6).s.bulk));
  p.sigma_bulk = 0;
  EXPECT_EQ(Model(p).brdf(60, 60, 0).s.bulk, 0);
}

TEST(ReferenceModel, RefusesAnglesOutsideTheHemisphere) {
  const Model model(parameters());
  EXPECT_THROW(model.brdf(90, 0, 0), std::invalid_argument);
  EXPECT_THROW(model.brdf(0, -1, 0), std::invalid_argument);
  EXPECT_THROW(model.dhr(std::nan("")), std::invalid_argument);
  EXPECT_THROW(model.brdf(0, 0, std::numeric_limits<double>::infinity()), std::invalid_argument);
}

TEST(ReferenceModel, ThreadsShareOneCache) {
  const Model model(parameters());
  std::array<double, 4> values{};
  {
    std::vector<std::jthread> threads;
    for (double& value : values)
      threads.emplace_back([&] {
        for (int theta = 0; theta < 90; theta += 5) value += model.brdf(theta, 30, 10).s.total();
      });
  }
  double expected = 0;
  for (int theta = 0; theta < 90; theta += 5) expected += Model(parameters()).brdf(theta, 30, 10).s.total();
  for (const double value : values) EXPECT_EQ(value, expected);
}

double hemispherical_integral(const Model& model, double theta_i, Lobe lobe) {
  using Gauss = boost::math::quadrature::gauss<double, 25>;
  constexpr double radian = std::numbers::pi / 180;
  double sum = 0;
  const std::vector<double> edges{0, 10, 25, 40, 46, 51.26, 56, 65, 75, 82, 86, 88.5, 89.5, 89.9, 89.99, 90};
  for (std::size_t k = 0; k + 1 < edges.size(); ++k)
    sum += Gauss::integrate(
        [&](double theta) {
          const auto f = [&](double phi) {
            const Lobes lobes = model.brdf(theta_i, theta, phi).unpolarized();
            return lobe == Lobe::surface ? lobes.surface : lobe == Lobe::bulk ? lobes.bulk : lobes.retro;
          };
          const double ring = Gauss::integrate(f, 0, 30) + Gauss::integrate(f, 30, 90) +
                              Gauss::integrate(f, 90, 150) + Gauss::integrate(f, 150, 180);
          return 2 * ring * double(sin_degrees(theta) * cos_degrees(theta)) * radian * radian;
        },
        edges[k], edges[k + 1]);
  return sum;
}

TEST(ReferenceReflectance, DhrIsTheIntegralOfF) {
  // Panels of 25 points reach this if one of their edges is at the critical angle.
  constexpr double brute_force_tolerance = 1e-7;
  for (const auto normalization :
       {Normalization::hemispherical, Normalization::closed_form, Normalization::reciprocal})
    for (const auto autocovariance : {Autocovariance::lorentzian, Autocovariance::gaussian}) {
      if (normalization != Normalization::hemispherical && autocovariance == Autocovariance::gaussian)
        continue;
      const Model model(parameters(), {.normalization = normalization, .autocovariance = autocovariance});
      for (const double theta : {0.0, 40.0}) {
        const LobeReflectance r = model.dhr(theta).unpolarized();
        const Estimate parts[] = {r.surface, r.bulk, r.retro};
        for (const Lobe lobe : {Lobe::surface, Lobe::bulk, Lobe::retro}) {
          const Estimate& part = parts[static_cast<int>(lobe)];
          const double expected = hemispherical_integral(model, theta, lobe);
          EXPECT_NEAR(part.value / expected, 1, brute_force_tolerance)
              << lobe_names[static_cast<int>(lobe)] << " theta_i " << theta << ": " << part.value << ' '
              << expected;
          EXPECT_LT(part.error, dhr_tolerance);
        }
      }
    }
}

TEST(ReferenceReflectance, WithoutLossesDhrIsTheAmplitude) {
  // An index of one transmits all, V_m is off, and ∬ N/D dα dβ = 1.
  Parameters p = parameters();
  p.n_eff = 1;
  p.k_eff = 0;
  for (const auto autocovariance : {Autocovariance::lorentzian, Autocovariance::gaussian})
    for (const double w : {0.05, 0.9}) {
      p.w = w;
      const Model model(
          p, {.autocovariance = autocovariance, .reflectance_shadowing = ReflectanceShadowing::none});
      for (const double theta : thetas) {
        const Reflectance r = model.dhr(theta);
        EXPECT_EQ(r.s.surface.value, 0) << theta;
        EXPECT_NEAR(r.s.bulk.value / p.sigma_bulk, 1, dhr_tolerance) << "w " << w << " theta_i " << theta;
        EXPECT_NEAR(r.p.retro.value / p.sigma_retro, 1, dhr_tolerance) << "w " << w << " theta_i " << theta;
      }
      EXPECT_NEAR(model.bhr().unpolarized().total().value / (p.sigma_bulk + p.sigma_retro), 1, dhr_tolerance)
          << w;
    }
}

TEST(ReferenceReflectance, BhrIsTheMeanOfDhr) {
  const Model model(parameters());
  using Gauss = boost::math::quadrature::gauss<double, 15>;
  const auto integrand = [&](double theta) {
    return 2 * model.dhr(theta).unpolarized().total().value *
           double(sin_degrees(theta) * cos_degrees(theta)) * std::numbers::pi / 180;
  };
  const double expected = Gauss::integrate(integrand, 0, 51.26) + Gauss::integrate(integrand, 51.26, 90);
  EXPECT_NEAR(model.bhr().unpolarized().total().value / expected, 1, 1e-5);
}

}  // namespace
}  // namespace brdftab::reference

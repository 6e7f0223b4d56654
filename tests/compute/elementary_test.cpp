// Our own elementary and special functions against long double and Boost: the errors that their comments and
// the kernels' documentation state, in units in the last place (ulp).
#include <boost/math/special_functions/gamma.hpp>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host/compute/on_host/kernel_constants.hpp"

#define BRDFTAB_WORKING_DOUBLE 1
namespace {
using real = double;
#include "kernels/angles.h"
#include "kernels/elementary.h"
#include "kernels/incomplete_gamma.h"
}  // namespace

namespace {

double ulps(double value, long double exact) {
  const double nearest = static_cast<double>(exact);
  const double spacing = std::nextafter(std::abs(nearest), INFINITY) - std::abs(nearest);
  return static_cast<double>(std::abs(value - exact)) / spacing;
}

// The largest error of `function` at random points, whose distribution `point` knows.
template <class Point, class Function, class Exact>
double worst_ulps(Point point, Function function, Exact exact) {
  std::mt19937_64 random(31);
  double worst = 0;
  for (int k = 0; k < 200000; ++k) {
    const double x = point(random);
    worst = std::max(worst, ulps(function(x), exact(static_cast<long double>(x))));
  }
  testing::Test::RecordProperty("worst_ulps", std::to_string(worst));
  return worst;
}

auto uniform(double low, double high) {
  return [=](std::mt19937_64& random) { return std::uniform_real_distribution(low, high)(random); };
}

// Points have both signs and cover many decades.
auto decades(double low, double high, double sign) {
  return [=](std::mt19937_64& random) {
    return sign * std::exp(std::uniform_real_distribution(std::log(low), std::log(high))(random));
  };
}

TEST(Elementary, Exponential) {
  EXPECT_LE(worst_ulps(uniform(-708, 708), exponential, [](long double x) { return std::exp(x); }), 1.0);
  EXPECT_LE(worst_ulps(decades(1e-20, 1, -1), exponential, [](long double x) { return std::exp(x); }), 1.0);
  EXPECT_EQ(exponential(0), 1);
  EXPECT_EQ(exponential(-1e9), 0);
  EXPECT_EQ(exponential(1e9), INFINITY);
}

TEST(Elementary, ExponentialLess1) {
  const auto exact = [](long double x) { return std::expm1(x); };
  EXPECT_LE(worst_ulps(decades(1e-300, 700, -1), exponential_less_1, exact), 2.0);
  EXPECT_LE(worst_ulps(decades(1e-300, 700, 1), exponential_less_1, exact), 2.0);
}

TEST(Elementary, Logarithm) {
  const auto exact = [](long double x) { return std::log(x); };
  EXPECT_LE(worst_ulps(decades(1e-307, 1e307, 1), logarithm, exact), 1.0);
  EXPECT_LE(worst_ulps(uniform(0.5, 2), logarithm, exact), 1.0);
  EXPECT_EQ(logarithm(1), 0);
  EXPECT_LT(logarithm(0), -708);
}

TEST(Elementary, LogarithmOfSum) {
  const auto exact = [](long double x) { return std::log1p(x); };
  EXPECT_LE(worst_ulps(decades(1e-300, 1e300, 1), logarithm_1_plus, exact), 2.0);
  EXPECT_LE(worst_ulps(decades(1e-300, 0.999, -1), logarithm_1_plus, exact), 2.0);
}

TEST(Elementary, SineAndCosineOfDegrees) {
  const long double degree = std::acos(-1.0L) / 180;
  const auto sine = [](double x) { return sincos_degrees(x).sine; };
  const auto cosine = [](double x) { return sincos_degrees(x).cosine; };
  EXPECT_LE(worst_ulps(uniform(0, 89.99), sine, [&](long double x) { return std::sin(x * degree); }), 2.0);
  // cos goes through 90 - x, which is exact: long double's pi would lose digits near 90 degrees.
  EXPECT_LE(
      worst_ulps(uniform(45, 89.99999), cosine, [&](long double x) { return std::sin((90 - x) * degree); }),
      2.0);
  EXPECT_LE(worst_ulps(uniform(-45, 45), cosine, [&](long double x) { return std::cos(x * degree); }), 2.0);
  EXPECT_EQ(sine(180), 0);
  EXPECT_EQ(cosine(270), 0);
}

TEST(Elementary, NanStaysNan) {
  for (const auto function : {exponential, exponential_less_1, logarithm, logarithm_1_plus})
    EXPECT_TRUE(std::isnan(function(NAN)));
  EXPECT_TRUE(std::isnan(logarithm(-1)));
  EXPECT_EQ(logarithm(INFINITY), INFINITY);
}

MaterialConstants constants(double n, double w) {
  brdftab::Parameters p{1.3, 0.1, 1, 0.2, 0.7, 0.5, 0.25, 0.1, 0.2, 0.1, 1, 0.3, w, n};
  return brdftab::material_constants<MaterialConstants>(p);
}

// Q and its logarithm over the whole range of n and w. A relative error of the exponent a (lambda - 1 - ln
// lambda) shows in Q times that exponent, so the bound grows with it.
TEST(Elementary, UpperGamma) {
  std::mt19937_64 random(32);
  double worst = 0;
  double worst_logarithm = 0;
  for (int k = 0; k < 20000; ++k) {
    const double n = k % 4 == 0   ? std::floor(uniform(0, 60)(random))
                     : k % 4 == 1 ? uniform(0, 3)(random)
                                  : uniform(0, 60)(random);
    const double w = decades(0.05, 10, 1)(random);
    const double sine = uniform(0, 1)(random);
    const MaterialConstants m = constants(n, w);
    const double lambda = sine * sine * m.inverse_w2;
    const auto q = upper_gamma(lambda, m);
    const long double a = 1 + static_cast<long double>(n);
    const long double x = a * static_cast<long double>(lambda);
    if (x > 600) continue;
    const long double exact = boost::math::gamma_q(a, x);
    const double exponent =
        std::abs(static_cast<double>(a * (lambda - 1 - std::log(static_cast<long double>(lambda)))));
    worst = std::max(worst, static_cast<double>(std::abs(q.value / exact - 1)) / (1 + exponent));
    if (exact < 0.99L)
      worst_logarithm =
          std::max(worst_logarithm, static_cast<double>(std::abs(q.logarithm / std::log(exact) - 1)));
  }
  RecordProperty("worst_relative_error", fmt::format("{}", worst));
  EXPECT_LE(worst, 2e-15);
  EXPECT_LE(worst_logarithm, 2e-13);
}

}  // namespace

// Rungs 1 and 2: the kernels' maths compiled as C++, against the scalar reference, over random parameters
// from the whole valid ranges and their ends.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/compute/on_host/kernels_on_host.hpp"
#include "host/reference/model.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

using kernels_on_host::Double;
using kernels_on_host::Float;

// What the project promises; measured: 1e-13 and 1e-14.
constexpr double tolerance_f = 1e-12;
constexpr double tolerance_n = 1e-10;
// Single precision carries 6e-8; an exponential tail of V or V_m multiplies that by its exponent, up to 70
// above 1e-30.
constexpr double tolerance_f_float = 5e-5;
constexpr double tolerance_n_float = 1e-4;
constexpr double smallest_f = 1e-30;

// Lobes are tried at their centres, near them, and anywhere.
struct Pair {
  double theta_i, theta_s, phi;
};

Pair random_pair(RandomMaterials& random, double theta_i) {
  switch (static_cast<int>(random.uniform(0, 4))) {
    case 0:
      return {theta_i, theta_i, (random.chance(0.5) ? 0 : 180) + random.uniform(0, 0.5)};
    case 1:
      return {theta_i, std::min(89.9, theta_i + random.uniform(0, 1)), random.uniform(0, 2)};
    case 2:
      return {theta_i, std::min(89.9, theta_i + random.uniform(0, 1e-3)), 180 + random.uniform(0, 1e-3)};
    default:
      return {theta_i, random.theta(), random.phi()};
  }
}

template <class Body>
void for_random_directions(unsigned seed, int materials, bool variants, Body body) {
  RandomMaterials random(seed);
  for (int k = 0; k < materials; ++k) {
    const Parameters parameters = k % 3 == 0 ? random.plausible() : random.parameters();
    const Variant variant = variants ? random.variant() : Variant{};
    SCOPED_TRACE(text_of(parameters) + text_of(variant));
    const reference::Model model(parameters, variant);
    for (int i = 0; i < 4; ++i) {
      const double theta_i = random.theta();
      for (int s = 0; s < 4; ++s) body(parameters, variant, model, random_pair(random, theta_i));
      if (testing::Test::HasFailure()) return;
    }
  }
}

void expect_close(double value, double expected, double tolerance, const Pair& at, const char* what) {
  if (std::isinf(value) && std::isinf(expected)) return;
  if (expected < smallest_f && value < 2 * smallest_f) return;
  EXPECT_LE(std::abs(value - expected), tolerance * expected)
      << what << " at theta_i = " << at.theta_i << ", theta_s = " << at.theta_s << ", phi = " << at.phi
      << ": " << fmt::format("{:.17g}", value) << ", expected " << fmt::format("{:.17g}", expected)
      << ", relative " << value / expected - 1;
}

class KernelsInDouble : public testing::TestWithParam<bool> {};

TEST_P(KernelsInDouble, BrdfEqualsReference) {
  int compared = 0;
  for_random_directions(11, 600, GetParam(),
                        [&](const auto& parameters, const auto& variant, const auto& model, const Pair& at) {
                          // A Gaussian lobe may be so narrow that N overflows; the program refuses it before
                          // any f.
                          for (const Lobe lobe : {Lobe::surface, Lobe::bulk, Lobe::retro})
                            for (const double theta : {at.theta_i, at.theta_s})
                              if (std::isinf(Double::normalization(parameters, variant, lobe, theta).value))
                                return;
                          const auto f = Double::brdf(parameters, variant, at.theta_i, at.theta_s, at.phi);
                          const auto expected = model.brdf(at.theta_i, at.theta_s, at.phi);
                          expect_close(f.s, expected.s.total(), tolerance_f, at, "f_s");
                          expect_close(f.p, expected.p.total(), tolerance_f, at, "f_p");
                          compared += expected.s.total() > smallest_f;
                        });
  EXPECT_GT(compared, 3000);
}

TEST_P(KernelsInDouble, NormalizationEqualsReference) {
  for_random_directions(12, 300, GetParam(),
                        [&](const auto& parameters, const auto& variant, const auto& model, const Pair& at) {
                          for (const Lobe lobe : {Lobe::surface, Lobe::bulk, Lobe::retro}) {
                            const auto n = Double::normalization(parameters, variant, lobe, at.theta_i);
                            expect_close(n.value, model.normalization(lobe, at.theta_i).value, tolerance_n,
                                         at, "N");
                            EXPECT_LE(n.error, tolerance_n);
                          }
                        });
}

INSTANTIATE_TEST_SUITE_P(Model, KernelsInDouble, testing::Values(false, true),
                         [](const auto& test) { return test.param ? "Variants" : "Default"; });

// The float build is for devices without fp64; only plausible materials, whose constants float holds.
TEST(KernelsInFloat, EqualsDouble) {
  RandomMaterials random(13);
  double worst = 0;
  for (int k = 0; k < 300; ++k) {
    const Parameters parameters = random.plausible();
    SCOPED_TRACE(text_of(parameters));
    for (int i = 0; i < 8; ++i) {
      // Angles that float holds exactly, so that both precisions see one direction.
      const auto exact = [&](double angle) { return std::floor(angle * 64) / 64; };
      const Pair at{exact(random.uniform(0, 85)), exact(random.uniform(0, 85)), exact(random.phi())};
      const auto f = Float::brdf(parameters, {}, at.theta_i, at.theta_s, at.phi);
      const auto expected = Double::brdf(parameters, {}, at.theta_i, at.theta_s, at.phi);
      if (expected.s < 1e-20 || expected.p < 1e-20) continue;
      expect_close(f.s, expected.s, tolerance_f_float, at, "f_s");
      expect_close(f.p, expected.p, tolerance_f_float, at, "f_p");
      worst = std::max({worst, std::abs(f.s / expected.s - 1), std::abs(f.p / expected.p - 1)});
      for (const Lobe lobe : {Lobe::surface, Lobe::bulk, Lobe::retro})
        expect_close(Float::normalization(parameters, {}, lobe, at.theta_i).value,
                     Double::normalization(parameters, {}, lobe, at.theta_i).value, tolerance_n_float, at,
                     "N");
      if (HasFailure()) return;
    }
  }
  RecordProperty("worst_relative_error", fmt::format("{}", worst));
  EXPECT_GT(worst, 1e-8) << "float arithmetic was not used";
}

TEST(KernelsInDouble, VanishesExactlyUnderTotalReflection) {
  // n_eff < 1, k_eff = 0: beyond the critical angle nothing enters the bulk.
  Parameters p{0.5, 0, 0, 0.3, 1, 0.5, 1, 0.5, 0.1, 0.1, 1, 1, 1, 1};
  const auto f = Double::brdf(p, {}, 60, 45, 30);
  EXPECT_EQ(f.s, 0);
  EXPECT_EQ(f.p, 0);
  EXPECT_GT(Double::brdf(p, {}, 20, 20, 30).s, 0);
}

TEST(KernelsInDouble, NoSurfaceWithoutContrast) {
  // n_eff = 1, k_eff = 0: no interface, no reflection at any angle.
  Parameters p{1, 0, 1, 0.3, 0, 0.5, 0, 0.5, 0.1, 0.1, 1, 1, 1, 1};
  for (const double theta : {0., 30., 89.9}) {
    EXPECT_EQ(Double::brdf(p, {}, theta, 60, 10).s, 0);
    EXPECT_EQ(Double::brdf(p, {}, theta, 60, 10).p, 0);
  }
}

TEST(KernelsInDouble, ReciprocalNormalizationIsSymmetricWithoutReflectanceShadowing) {
  RandomMaterials random(14);
  Variant variant;
  variant.normalization = Normalization::reciprocal;
  variant.reflectance_shadowing = ReflectanceShadowing::none;
  Variant hemispherical = variant;
  hemispherical.normalization = Normalization::hemispherical;
  int asymmetric = 0;
  for (int k = 0; k < 100; ++k) {
    const Parameters p = random.plausible();
    const double i = random.uniform(0, 85);
    const double s = random.uniform(0, 85);
    const double phi = random.phi();
    SCOPED_TRACE(text_of(p));
    const auto forth = Double::brdf(p, variant, i, s, phi);
    const auto back = Double::brdf(p, variant, s, i, phi);
    EXPECT_NEAR(forth.s, back.s, 1e-13 * back.s) << i << " " << s << " " << phi;
    EXPECT_NEAR(forth.p, back.p, 1e-13 * back.p) << i << " " << s << " " << phi;
    const double one_way = Double::brdf(p, hemispherical, i, s, phi).s;
    asymmetric += std::abs(one_way / Double::brdf(p, hemispherical, s, i, phi).s - 1) > 1e-6;
  }
  EXPECT_GT(asymmetric, 90);
}

}  // namespace
}  // namespace brdftab

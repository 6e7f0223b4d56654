// N, DHR and BHR: from the device against the reference's independent quadrature.
#include "host/compute/integrals.hpp"

#include <gtest/gtest.h>

#include "host/reference/model.hpp"
#include "host/table/energy.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

constexpr double tolerance_n = 1e-10;
constexpr double tolerance_dhr = 1e-8;
// DHR smaller than this is compared absolutely.
constexpr double smallest_dhr = 1e-12;

class OnDevice : public testing::Test {
 protected:
  void SetUp() override {
    if (!device_.has_fp64) GTEST_SKIP() << "the device has no fp64";
    engine_.emplace(device_, Precision::float64, Precision::float32);
  }
  const Device device_ = select_device(std::nullopt);
  std::optional<Engine> engine_;
};

void compare(const Engine& engine, const Parameters& p, const Variant& variant,
             const std::vector<double>& theta) {
  SCOPED_TRACE(text_of(p) + text_of(variant));
  const Band band{std::nullopt, p};
  const Integrals device = integrals(engine, band, variant, theta);
  const Integrals reference = reference_integrals(band, variant, theta);
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    for (std::size_t k = 0; k < theta.size(); ++k) {
      const std::string at = fmt::format("{} lobe, theta_i = {}", lobe_names[lobe], theta[k]);
      const double n = reference.normalization.value[lobe][k];
      EXPECT_NEAR(device.normalization.value[lobe][k], n, tolerance_n * n) << at;
      for (const auto member : {&Dhr::s, &Dhr::p}) {
        const double expected = (reference.dhr.*member)[lobe][k];
        EXPECT_NEAR((device.dhr.*member)[lobe][k], expected,
                    tolerance_dhr * expected + smallest_dhr * tolerance_dhr)
            << at;
      }
      EXPECT_LE(device.dhr.error[lobe][k], tolerance_dhr) << at;
    }
}

TEST_F(OnDevice, IntegralsEqualReferenceForPlausibleMaterials) {
  RandomMaterials random(31);
  for (int k = 0; k < 8 && !HasFailure(); ++k)
    compare(*engine_, random.plausible(), {}, {0, random.uniform(0, 60), random.uniform(60, 85), 89.9});
}

TEST_F(OnDevice, IntegralsEqualReferenceForVariants) {
  RandomMaterials random(32);
  for (int k = 0; k < 8 && !HasFailure(); ++k) {
    const Parameters p = random.plausible();
    compare(*engine_, p, random.variant(), {0, random.uniform(0, 60), random.uniform(60, 85)});
  }
}

// A lossless lobe: no shadowing, no interface (R = 0), so DHR of the bulk lobe is its amplitude times the
// whole of N/D.
TEST_F(OnDevice, LosslessBulkLobeReflectsItsAmplitude) {
  const Parameters p{1, 0, 1, 0.2, 0.7, 0.05, 0.25, 0.01, 0, 0, 0, 0, 1.2, 7};
  const Integrals at = integrals(*engine_, {std::nullopt, p}, {}, std::vector<double>{0, 30, 60, 85, 89.9});
  for (std::size_t k = 0; k < 5; ++k) {
    EXPECT_EQ(at.dhr.lobe(0, k, Polarization::unpolarized), 0);
    EXPECT_NEAR(at.dhr.lobe(1, k, Polarization::unpolarized), 0.7, 0.7 * tolerance_dhr);
    EXPECT_NEAR(at.dhr.lobe(2, k, Polarization::unpolarized), 0.25, 0.25 * tolerance_dhr);
  }
  const Bhr albedo = bhr(*engine_, {std::nullopt, p}, {});
  EXPECT_NEAR(albedo.of(Polarization::unpolarized), 0.95, 1e-7);
}

TEST_F(OnDevice, BhrEqualsReference) {
  for (const char* name : {"garnet-red-paint"}) {
    const Material m = Material::read(fmt::format("{}/{}.toml", BRDFTAB_MATERIALS_DIR, name));
    const Bhr device = bhr(*engine_, m.bands()[0], m.variant());
    const Bhr reference = reference_bhr(m.bands()[0], m.variant());
    EXPECT_NEAR(device.s, reference.s, 1e-7 * reference.s) << name;
    EXPECT_NEAR(device.p, reference.p, 1e-7 * reference.p) << name;
  }
}

TEST_F(OnDevice, EnergyIsWarnedOfByAngleAndLobe) {
  const Parameters p{1, 0, 1, 0.2, 0.7, 0.05, 1.25, 0.01, 0, 0, 0, 0, 1.2, 7};
  const Band band{std::nullopt, p};
  const Material m = Material::parse(
      "name = \"bright\"\n[parameters]\nn_eff = 1\nk_eff = 0\nsigma_surface = 1\nrho_surface = "
      "0.2\nsigma_bulk = 0.7\n"
      "rho_bulk = 0.05\nsigma_retro = 1.25\nrho_retro = 0.01\nw_a = 0\nw_b = 0\ngamma = 0\ndelta = 0\nw = "
      "1.2\nn = 7\n",
      "bright");
  const std::vector<double> theta{0, 40};
  const auto warnings = energy_warnings(m, m.bands()[0], theta, integrals(*engine_, band, {}, theta).dhr,
                                        {Polarization::unpolarized});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("theta_i ="), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("retro lobe has 1.25"), std::string::npos) << warnings[0];
}

TEST_F(OnDevice, ReciprocityIsPerfectWhereTheModelIsSymmetric) {
  const Parameters p{1.3, 0.1, 1, 0.2, 0.7, 0.5, 0.25, 0.1, 0.2, 0.1, 1, 0.3, 1.2, 7};
  Variant symmetric;
  symmetric.normalization = Normalization::reciprocal;
  symmetric.reflectance_shadowing = ReflectanceShadowing::none;
  EXPECT_LE(reciprocity({std::nullopt, p}, symmetric).maximum, 1e-12);
  const auto defect = reciprocity({std::nullopt, p}, {});
  EXPECT_GT(defect.median, 1e-3);
  EXPECT_LE(defect.median, defect.percentile_90);
  EXPECT_LE(defect.percentile_90, defect.maximum);
}

}  // namespace
}  // namespace brdftab

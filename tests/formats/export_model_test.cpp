// What writers of simulators' formats are given, against the scalar reference and published figures.
#include "host/formats/export/export_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "host/model/surface_vector.hpp"
#include "host/reference/model.hpp"

namespace brdftab {
namespace {

const Engine& engine() {
  static const Device device = select_device(std::nullopt);
  static const Engine engine(device, Engine::widest(device), Precision::float32);
  return engine;
}

Material material(const std::string& name) {
  return Material::read(std::string(BRDFTAB_MATERIALS_DIR) + "/" + name + ".toml");
}

Directions random_directions(std::size_t count, double largest_theta) {
  std::mt19937_64 random(11);
  std::uniform_real_distribution<double> theta(0, largest_theta), phi(-360, 360);
  Directions directions;
  // Many theta_i and small ones: N comes from its curve, which is mirrored at 0.
  for (std::size_t k = 0; k < count; ++k)
    directions.add(k % 4 ? theta(random) : 1e-4 * theta(random), theta(random), phi(random));
  return directions;
}

class Exported : public testing::TestWithParam<const char*> {};

TEST_P(Exported, ManyDirectionsAreTheReference) {
  if (engine().working() != Precision::float64) GTEST_SKIP() << "the device has no fp64";
  const Material m = material(GetParam());
  const ExportModel source(engine(), m, {});
  const Directions directions = random_directions(1200, 89.9999);
  const auto f = source.evaluate(directions);
  const reference::Model model(m.bands().front().parameters, m.variant());
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double expected =
        model.brdf(directions.theta_i[k], directions.theta_s[k], directions.phi[k]).unpolarized().total();
    if (expected <= 1e-30) continue;
    EXPECT_LT(std::abs(f[0][k] / expected - 1), 1e-11)
        << directions.theta_i[k] << " " << directions.theta_s[k] << " " << directions.phi[k] << ": "
        << f[0][k] << " " << expected;
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, Exported,
                         testing::Values("brown-vinyl", "garnet-red-paint", "white-ptfe",
                                         "yellow-retro-sheeting"));

TEST(ExportModel, FewDirectionsAreThoseAmongMany) {
  if (engine().working() != Precision::float64) GTEST_SKIP() << "the device has no fp64";
  const ExportModel source(engine(), material("garnet-red-paint"), {});
  const Directions many = random_directions(1000, 85);
  Directions few;
  for (std::size_t k = 0; k < 20; ++k) few.add(many.theta_i[k], many.theta_s[k], many.phi[k]);
  for (const Polarization polarization : {Polarization::unpolarized, Polarization::s, Polarization::p}) {
    const auto a = source.evaluate(few, polarization), b = source.evaluate(many, polarization);
    for (std::size_t k = 0; k < few.size(); ++k) EXPECT_LT(std::abs(a[0][k] / b[0][k] - 1), 1e-11);
  }
}

TEST(ExportModel, ReciprocalNormalizationTakesBothAngles) {
  if (engine().working() != Precision::float64) GTEST_SKIP() << "the device has no fp64";
  const Material base = material("garnet-red-paint");
  const Material m =
      Material::parse(base.text() + "\n[model]\nnormalization = \"reciprocal\"\n", "reciprocal");
  const ExportModel source(engine(), m, {});
  const Directions directions = random_directions(700, 80);
  const auto f = source.evaluate(directions);
  const reference::Model model(m.bands().front().parameters, m.variant());
  for (std::size_t k = 0; k < directions.size(); k += 35) {
    const double expected =
        model.brdf(directions.theta_i[k], directions.theta_s[k], directions.phi[k]).unpolarized().total();
    EXPECT_LT(std::abs(f[0][k] / expected - 1), 1e-10);
  }
}

// The sum over a spectrum of f at the bands.
double seen(const std::vector<double>& weights, const std::vector<double>& f) {
  return std::inner_product(weights.begin(), weights.end(), f.begin(), 0.);
}

TEST(Colorimetry, WhiteIsEqualInAllChannels) {
  for (const Illuminant illuminant : {Illuminant::d65, Illuminant::equal_energy})
    for (const std::vector<double>& bands :
         {std::vector<double>{}, {633}, {450, 550, 650}, {300, 380, 381, 500, 700, 1500}}) {
      const std::vector<double> white(std::max<std::size_t>(bands.size(), 1), 0.25);
      for (const auto& weights : {xyz_weights(bands, illuminant), rgb_weights(bands, illuminant)})
        for (const auto& channel : weights) EXPECT_NEAR(seen(channel, white), 0.25, 1e-15);
    }
  EXPECT_EQ(rgb_weights({}, Illuminant::d65), (ChannelWeights{{{1}, {1}, {1}}}));  // exactly grey
}

// f = 0.1, 0.5, 0.2 at 450, 550, 650 nm: by colour-science 0.4.7 from its own tables, XYZ relative to the
// white's, and linear sRGB after Bradford adaptation.
TEST(Colorimetry, SpectrumOfThreeBands) {
  const std::vector<double> f{0.1, 0.5, 0.2};
  const auto expect = [&](const ChannelWeights& weights, const std::array<double, 3>& expected) {
    for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(seen(weights[c], f), expected[c], 1e-12) << c;
  };
  const std::vector<double> bands{450, 550, 650};
  expect(xyz_weights(bands, Illuminant::d65),
         {0.31691735271001553, 0.38812721513185067, 0.14771778121939194});
  expect(rgb_weights(bands, Illuminant::d65), {0.29929788427831766, 0.4428492041511175, 0.10762362263347874});
  expect(xyz_weights(bands, Illuminant::equal_energy),
         {0.3169364512594936, 0.38633229030642263, 0.1457189328337406});
  expect(rgb_weights(bands, Illuminant::equal_energy),
         {0.2835074122693532, 0.4458501750147968, 0.10498083525203346});
}

// Beyond the bands, and where one lies outside what is visible, f is that of the nearest.
TEST(Colorimetry, BandsOutsideTheVisibleCountForNothing) {
  for (const auto& channel : rgb_weights({200, 300, 900}, Illuminant::d65)) EXPECT_EQ(channel[0], 0);
}

TEST(SurfaceVector, TheMirrorDirectionIsForwardAndTheLightIsBackward) {
  for (const double theta : {0.0, 1e-5, 30.0, 89.9999})
    for (const double azimuth : {-170.0, 0.0, 10.0, 90.0}) {
      const auto light = SurfaceVector::from_degrees(theta, azimuth);
      Directions directions;
      add(directions, light, {-light.x, -light.y, light.z});
      add(directions, light, light);
      EXPECT_NEAR(directions.theta_i[0], theta, 1e-12);
      EXPECT_NEAR(directions.theta_s[0], theta, 1e-12);
      if (theta == 0) continue;
      EXPECT_NEAR(std::remainder(directions.phi[0], 360), 0, 1e-9);
      EXPECT_NEAR(std::abs(std::remainder(directions.phi[1], 360)), 180, 1e-9);
    }
}

TEST(SurfaceVector, PairsComeBack) {
  const Directions directions = random_directions(100, 89);
  Directions again;
  for (std::size_t k = 0; k < directions.size(); ++k)
    add(again, to_light(directions, k), to_viewer(directions, k));
  for (std::size_t k = 0; k < directions.size(); ++k) {
    EXPECT_NEAR(again.theta_i[k], directions.theta_i[k], 1e-11);
    EXPECT_NEAR(again.theta_s[k], directions.theta_s[k], 1e-11);
    EXPECT_NEAR(std::remainder(again.phi[k] - directions.phi[k], 360), 0, 1e-9);
  }
}

TEST(SurfaceVector, AboutTheSpecularDirection) {
  // Toward the normal by the angle of incidence is the normal, by twice that the light.
  EXPECT_NEAR(about_specular(40, 40, 0).theta(), 0, 1e-9);
  EXPECT_NEAR(about_specular(40, 80, 0).theta(), 40, 1e-9);
  EXPECT_NEAR(std::abs(about_specular(40, 80, 0).phi()), 180, 1e-9);
  EXPECT_NEAR(about_specular(40, 0, 77).theta(), 40, 1e-9);
  EXPECT_NEAR(about_specular(40, 10, 180).theta(), 50, 1e-9);
  for (const double azimuth : {0.0, 20.0, 135.0, 300.0}) {
    const auto [radial, again] = specular_angles(62, about_specular(62, 25, azimuth));
    EXPECT_NEAR(radial, 25, 1e-11);
    EXPECT_NEAR(again, azimuth, 1e-9);
  }
}

}  // namespace
}  // namespace brdftab

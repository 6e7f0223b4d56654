// The model as grids are chosen with it, and the axes: against the scalar reference and known functions.
#include "host/table/grid_choice.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host/compute/evaluate.hpp"

namespace brdftab {
namespace {

class GridChoice : public testing::Test {
 protected:
  void SetUp() override {
    if (!device_.has_fp64) GTEST_SKIP() << "the device has no fp64";
  }

  static Material shipped(const char* name) {
    return Material::read(std::filesystem::path(BRDFTAB_MATERIALS_DIR) / (std::string(name) + ".toml"));
  }

  const Device device_ = select_device(std::nullopt);
};

// N comes from a curve between integrals.
constexpr double curve_tolerance = 1e-10;

TEST_F(GridChoice, SampledModelIsTheReference) {
  const Engine engine(device_, Precision::float64, Precision::float32);
  for (const char* name : {"brown-vinyl", "garnet-red-paint", "white-ptfe", "yellow-retro-sheeting"})
    for (const Normalization normalization : {Normalization::hemispherical, Normalization::reciprocal}) {
      std::string text = shipped(name).text();
      if (normalization == Normalization::reciprocal) text += "[model]\nnormalization = \"reciprocal\"\n";
      const Material material = Material::parse(text, name);
      const std::vector<Polarization> polarizations{Polarization::unpolarized, Polarization::s,
                                                    Polarization::p};
      const SampledModel model(engine, material, polarizations, {0, 88}, {0, 89});
      DirectionDraw source({0, 88}, {0, 89}, 11);
      Directions directions;
      std::vector<DirectionPair> pairs;
      for (int k = 0; k < 60; ++k) {
        const double i = source.theta_i(), s = source.near(i, {0, 89}), phi = source.azimuth();
        directions.add(i, s, phi);
        pairs.push_back({i, s, phi, 0});
      }
      const auto f = model.evaluate(directions);
      const auto expected = evaluate_reference(material.bands().front(), material.variant(), pairs);
      ASSERT_EQ(f.size(), 3);
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto where =
            fmt::format("{} at {}, {}, {}", name, pairs[k].theta_i, pairs[k].theta_s, pairs[k].phi);
        EXPECT_NEAR(f[0][k] / expected[k].unpolarized(), 1, curve_tolerance) << where;
        EXPECT_NEAR(f[1][k] / expected[k].s, 1, curve_tolerance) << where;
        EXPECT_NEAR(f[2][k] / expected[k].p, 1, curve_tolerance) << where;
        // No direction is brighter than the slice's peak, but between the angles at which peaks are sought.
        EXPECT_LE(f[0][k], 1.2 * model.peak(0, pairs[k].theta_i)) << where;
      }
    }
}

// Where one axis alone is interpolated with the density that its error asks for, the error is about that.
TEST_F(GridChoice, DensityGivesTheErrorAskedFor) {
  const Engine engine(device_, Precision::float64, Precision::float32);
  const Material material = shipped("brown-vinyl");
  const SampledModel model(engine, material, {Polarization::unpolarized}, {0, 85}, {0, 89});
  DirectionDraw source({0, 85}, {0, 89}, 5);
  const double asked = 0.01;
  const auto nodes = AxisDensity(model, ChosenAxis::theta_s, {0, 89}, asked, source).nodes(1);
  EXPECT_EQ(nodes.front(), 0);
  EXPECT_EQ(nodes.back(), 89);
  Directions at, low, high;
  DirectionDraw fresh({0, 85}, {0, 89}, 6);
  for (std::size_t k = 1; k < nodes.size(); ++k)
    for (int j = 0; j < 500; ++j) {
      const double middle = 0.5 * (nodes[k - 1] + nodes[k]), i = fresh.near(middle, {0, 85}),
                   phi = fresh.azimuth();
      at.add(i, middle, phi);
      low.add(i, nodes[k - 1], phi);
      high.add(i, nodes[k], phi);
    }
  const auto f = model.evaluate(at);
  auto mean = model.evaluate(low);
  const auto upper = model.evaluate(high);
  for (std::size_t k = 0; k < at.size(); ++k) mean[0][k] = 0.5 * (mean[0][k] + upper[0][k]);
  const auto errors = relative_errors(model, at, f, mean);
  const double largest = *std::max_element(errors.begin(), errors.end());
  EXPECT_LT(largest, 1.5 * asked);
  EXPECT_GT(largest, 0.5 * asked);
}

TEST_F(GridChoice, TakesFewerNodesThanUniformAxes) {
  const Engine engine(device_, Precision::float64, Precision::float32);
  const Material material = shipped("white-ptfe");
  Grid ranges;
  GridChooser chooser(engine, material, {Polarization::unpolarized}, ranges, 0.05);
  const GridAtError chosen = chooser.choose(1e9);
  EXPECT_LE(chosen.error.maximum, 0.05);
  EXPECT_LE(chosen.error.uniform_maximum, chosen.error.maximum);
  EXPECT_LE(chosen.error.percentile_95, chosen.error.maximum);
  for (const bool uniform_directions : {true, false}) {
    const UniformNeed need = chooser.uniform_need(uniform_directions);
    EXPECT_LT(static_cast<double>(chosen.grid.directions()), need.alone.product());
    EXPECT_LE(need.alone.product(), need.together.product());
  }
}

}  // namespace
}  // namespace brdftab

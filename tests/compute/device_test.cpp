// Rung 3: the kernels on the OpenCL device, against the same source as C++ and against the scalar reference;
// direct path and factored path, in every precision.
#include <gtest/gtest.h>

#include <algorithm>

#include "host/base/error.hpp"
#include "host/compute/evaluate.hpp"
#include "host/compute/integrals.hpp"
#include "host/compute/on_host/kernel_constants.hpp"
#include "host/compute/on_host/kernels_on_host.hpp"
#include "host/compute/plan.hpp"
#include "host/reference/model.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

constexpr double tolerance_float32_table = 1e-6;
constexpr double tolerance_float64_table = 1e-12;
constexpr double smallest_f = 1e-30;

const Engine& engine(Precision working, Precision table) {
  static const Device device = select_device(std::nullopt);
  static const Engine both_wide(device, Precision::float64, Precision::float64);
  static const Engine usual(device, Precision::float64, Precision::float32);
  static const Engine narrow(device, Precision::float32, Precision::float32);
  return working == Precision::float32 ? narrow : table == Precision::float32 ? usual : both_wide;
}

#define REQUIRE_FP64() \
  if (!select_device(std::nullopt).has_fp64) GTEST_SKIP() << "the device has no fp64"

// A material is made by its file, which is the only way to have one.
Material material_of(const Parameters& p, const Variant& variant) {
  static const char* const normalizations[] = {"hemispherical", "reciprocal", "closed-form"};
  static const char* const shadowings[] = {"all", "surface", "none"};
  std::string text = "name = \"random\"\n[parameters]\n";
  for (const auto& row : parameter_table) text += fmt::format("{} = {}\n", row.name, p.*row.member);
  text += fmt::format(
      "[model]\nnormalization = \"{}\"\nautocovariance = \"{}\"\nforeshortening = {}\nwidth_shadowing = {}\n"
      "reflectance_shadowing = \"{}\"\n",
      normalizations[static_cast<int>(variant.normalization)],
      variant.autocovariance == Autocovariance::gaussian ? "gaussian" : "lorentzian", variant.foreshortening,
      variant.width_shadowing, shadowings[static_cast<int>(variant.reflectance_shadowing)]);
  return Material::parse(text, "random");
}

TEST(Device, SharedStructsHaveOneLayout) {
  for (const Precision working : {Precision::float32, Precision::float64}) {
    const Engine& e = engine(working, Precision::float32);
    const cl::Buffer bytes = e.buffer(4 * sizeof(cl_int));
    cl::Kernel kernel = e.kernel("layout");
    set_arguments(kernel, bytes);
    e.run_items(kernel, {1, 1, 1});
    const auto sizes = e.download_ints(bytes, 4);
    EXPECT_EQ(sizes[0], working == Precision::float64
                            ? static_cast<int>(sizeof(kernel_f64::MaterialConstants))
                            : static_cast<int>(sizeof(kernel_f32::MaterialConstants)));
    EXPECT_EQ(sizes[1], static_cast<int>(sizeof(kernel_f64::ModelVariant)));
    const double angle = 30;
    EXPECT_EQ(sizes[2], static_cast<int>(8 * bytes_of(working)));
    EXPECT_EQ(sizes[3],
              static_cast<int>(working == Precision::float64
                                   ? kernels_on_host::Double::azimuth_tables({&angle, 1}).factors.size()
                                   : kernels_on_host::Float::azimuth_tables({&angle, 1}).factors.size()));
  }
}

std::vector<DirectionPair> random_pairs(RandomMaterials& random, int incidences, int scatters) {
  std::vector<DirectionPair> pairs;
  for (int i = 0; i < incidences; ++i) {
    const double theta_i = std::floor(random.theta() * 64) / 64;
    for (int s = 0; s < scatters; ++s)
      pairs.push_back({theta_i, std::floor(random.theta() * 64) / 64, std::floor(random.phi() * 64) / 64, 0});
  }
  return pairs;
}

// The maths is IEEE arithmetic alone, each operation rounded by itself: every device gives the bits that the
// host gives.
TEST(Device, DirectPathHasTheBitsOfTheSameSourceInCpp) {
  REQUIRE_FP64();
  RandomMaterials random(21);
  for (int k = 0; k < 24; ++k) {
    const Parameters p = random.plausible();
    const Variant variant = k % 2 ? random.variant() : Variant{};
    SCOPED_TRACE(text_of(p) + text_of(variant));
    const auto pairs = random_pairs(random, 3, 30);
    const auto wide =
        evaluate(engine(Precision::float64, Precision::float32), {std::nullopt, p}, variant, pairs);
    const auto narrow =
        evaluate(engine(Precision::float32, Precision::float32), {std::nullopt, p}, variant, pairs);
    const auto f = kernels_on_host::Double::brdf(p, variant, pairs);
    const auto g = kernels_on_host::Float::brdf(p, variant, pairs);
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const auto at = fmt::format("{} {} {}", pairs[j].theta_i, pairs[j].theta_s, pairs[j].phi);
      EXPECT_EQ(wide[j].s, f[j].s) << at;
      EXPECT_EQ(wide[j].p, f[j].p) << at;
      if (!std::isnan(g[j].s)) {
        EXPECT_EQ(narrow[j].s, g[j].s) << at;
      }
    }
    if (HasFailure()) return;
  }
}

TEST(Device, WidthOfAWorkItemDoesNotChangeTheBits) {
  REQUIRE_FP64();
  RandomMaterials random(24);
  const Parameters p = random.plausible();
  const auto pairs = random_pairs(random, 5, 201);
  const auto expected = kernels_on_host::Double::brdf(p, {}, pairs);
  for (const std::size_t width : {1, 2, 4, 8, 16}) {
    const Engine e(select_device(std::nullopt), Precision::float64, Precision::float32, {}, width);
    const auto f = evaluate(e, {std::nullopt, p}, {}, pairs);
    for (std::size_t j = 0; j < pairs.size(); ++j)
      ASSERT_EQ(f[j].s, expected[j].s) << "width " << width << ", pair " << j;
  }
}

TEST(Device, NegativeThetaSIsTheBackwardSide) {
  REQUIRE_FP64();
  const Parameters p{1.24, 0, 1.9, .45, .073, .88, .061, 1.9, .21, .12, .9, 0, 2, 0};
  const std::vector<DirectionPair> pairs{
      {30, -40, 0, 0}, {30, 40, 180, 0}, {30, 40, -180, 0}, {30, 40, 0, 0}};
  const auto f = evaluate(engine(Precision::float64, Precision::float32), {std::nullopt, p}, {}, pairs);
  EXPECT_EQ(f[0].s, f[1].s);
  EXPECT_EQ(f[1].p, f[2].p);
  EXPECT_NE(f[0].s, f[3].s);
}

TEST(Device, RefusesAnAngleThatFloatRoundsTo90) {
  const Parameters p{1.24, 0, 1.9, .45, .073, .88, .061, 1.9, .21, .12, .9, 0, 2, 0};
  const std::vector<DirectionPair> pairs{{10, 89.9999999, 0, 0}};
  EXPECT_THROW(evaluate(engine(Precision::float32, Precision::float32), {std::nullopt, p}, {}, pairs),
               BadInput);
  REQUIRE_FP64();
  EXPECT_GT(evaluate(engine(Precision::float64, Precision::float32), {std::nullopt, p}, {}, pairs)[0].s, 0);
}

TEST(Plan, RefusesAnAngleThatFloatRoundsTo90) {
  const Engine& e = engine(Precision::float32, Precision::float32);
  const Material material = Material::read(std::string(BRDFTAB_MATERIALS_DIR) + "/brown-vinyl.toml");
  Grid grid = material.grid();
  grid.theta_i = Axis(AxisKind::theta_i, {0, 60});
  const auto plan = [&](double theta_s) {
    grid.theta_s = Axis(AxisKind::theta_s, {30, theta_s});
    Plan(e, material, material.bands()[0], grid,
         integrals(e, material.bands()[0], material.variant(), grid.theta_i.nodes()));
  };
  EXPECT_THROW(plan(89.9999999), BadInput);
  EXPECT_NO_THROW(plan(89.99));
}

struct TableCase {
  Precision precision;
  double tolerance;
};

class FactoredTable : public testing::TestWithParam<TableCase> {};

// Random axes that meet lobes at their centres; the factored path against the reference at every node.
TEST_P(FactoredTable, EqualsReferenceAtEveryNode) {
  REQUIRE_FP64();
  const Engine& e = engine(Precision::float64, GetParam().precision);
  RandomMaterials random(22);
  std::size_t compared = 0;
  double worst = 0;
  for (int k = 0; k < 60; ++k) {
    const Parameters p = k % 2 ? random.parameters() : random.plausible();
    const Variant variant = k % 4 < 2 ? Variant{} : random.variant();
    SCOPED_TRACE(text_of(p) + text_of(variant));
    const Material material = material_of(p, variant);
    Grid grid;
    std::vector<double> theta{0, random.uniform(1, 30), random.uniform(30, 60), random.uniform(60, 89), 89.9};
    grid.theta_i = Axis(AxisKind::theta_i, theta);
    grid.theta_s = Axis(AxisKind::theta_s, theta);
    grid.phi_i = Axis::parse(AxisKind::phi_i, k % 3 ? "0:270:90" : "0");
    grid.phi_s = Axis(AxisKind::phi_s,
                      {0.25, random.uniform(1, 80), 90, random.uniform(95, 170), 179.75, 270, 359.75});
    const Slab whole{{0, theta.size()}, {0, grid.phi_i.size()}, {0, theta.size()}, grid.phi_s.size()};
    const std::size_t bytes = whole.nodes() * bytes_of(e.table());
    const reference::Model model(p, variant);
    try {
      Plan plan(e, material, material.bands()[0], grid,
                integrals(e, material.bands()[0], material.variant(), grid.theta_i.nodes()));
      for (const Polarization polarization : {Polarization::unpolarized, Polarization::s, Polarization::p}) {
        const cl::Buffer samples = e.buffer(bytes);
        plan.tabulate(whole, polarization, samples);
        std::vector<std::byte> host(bytes);
        e.queue().enqueueReadBuffer(samples, CL_TRUE, 0, bytes, host.data());
        plan.check(whole, host);
        std::size_t at = 0;
        for (const double i : theta)
          for (const double phi_i : grid.phi_i.nodes())
            for (const double s : theta)
              for (const double phi_s : grid.phi_s.nodes()) {
                const double value = e.table() == Precision::float64
                                         ? reinterpret_cast<const double*>(host.data())[at]
                                         : reinterpret_cast<const float*>(host.data())[at];
                ++at;
                const auto f = model.brdf(i, s, phi_s - phi_i);
                const double expected = (polarization == Polarization::s   ? f.s
                                         : polarization == Polarization::p ? f.p
                                                                           : f.unpolarized())
                                            .total();
                if (expected < smallest_f) continue;
                const double error = std::abs(value / expected - 1);
                worst = std::max(worst, error);
                ++compared;
                ASSERT_LE(error, GetParam().tolerance)
                    << "theta_i = " << i << ", phi_i = " << phi_i << ", theta_s = " << s
                    << ", phi_s = " << phi_s << ": "
                    << fmt::format("{:.17g}, expected {:.17g}", value, expected);
              }
      }
    } catch (const BadInput& refused) {
      // A lobe too narrow for the precision is refused by name; the reference must agree that it is singular
      // or beyond it.
      EXPECT_NE(std::string(refused.what()).find("rho_"), std::string::npos) << refused.what();
    }
  }
  EXPECT_GT(compared, 20000u);
  RecordProperty("worst_relative_error", fmt::format("{}", worst));
}

INSTANTIATE_TEST_SUITE_P(Precision, FactoredTable,
                         testing::Values(TableCase{Precision::float32, tolerance_float32_table},
                                         TableCase{Precision::float64, tolerance_float64_table}),
                         [](const auto& test) { return std::string(name_of(test.param.precision)); });

// However a table is cut into slabs, a node has one value.
TEST(Plan, SlabsDoNotChangeTheBytes) {
  REQUIRE_FP64();
  const Engine& e = engine(Precision::float64, Precision::float32);
  const Material material = Material::read(std::string(BRDFTAB_MATERIALS_DIR) + "/garnet-red-paint.toml");
  Grid grid;
  grid.theta_i = Axis::parse(AxisKind::theta_i, "0:80:20");
  grid.phi_i = Axis::parse(AxisKind::phi_i, "0:330:30");
  grid.theta_s = Axis::parse(AxisKind::theta_s, "0:88:4");
  grid.phi_s = Axis::parse(AxisKind::phi_s, "0:360:10");
  const auto table = [&](std::size_t most_nodes) {
    Plan plan(e, material, material.bands()[0], grid,
              integrals(e, material.bands()[0], material.variant(), grid.theta_i.nodes()));
    std::vector<std::byte> all;
    for (const Slab& slab : slabs(grid, most_nodes)) {
      const std::size_t bytes = slab.nodes() * sizeof(float);
      const cl::Buffer samples = e.buffer(bytes);
      plan.tabulate(slab, Polarization::unpolarized, samples);
      std::vector<std::byte> host(bytes);
      e.queue().enqueueReadBuffer(samples, CL_TRUE, 0, bytes, host.data());
      plan.check(slab, host);
      all.insert(all.end(), host.begin(), host.end());
    }
    return all;
  };
  const auto whole = table(grid.directions());
  ASSERT_EQ(whole.size(), grid.directions() * sizeof(float));
  const std::size_t slice = grid.theta_s.size() * grid.phi_s.size();
  for (const std::size_t most :
       {std::size_t{1}, 3 * grid.phi_s.size(), slice, 5 * slice, 2 * grid.phi_i.size() * slice})
    EXPECT_TRUE(table(most) == whole) << "slabs of " << most << " nodes";
}

}  // namespace
}  // namespace brdftab

// Derivatives of ln f by the parameters: against differences of the scalar reference, and on the device
// against the same source as C++.
#include "host/compute/gradients.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "host/compute/on_host/kernels_on_host.hpp"
#include "host/reference/model.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

using kernels_on_host::Double;

// Ridders' extrapolated differences of the reference, which is good to 1e-13, keep about 1e-9; the test is
// sharp to the term. Relative to |derivative| + 1/scale of the parameter.
constexpr double tolerance_slope = 2e-7;
constexpr double tolerance_ln_f = 1e-9;
constexpr double tolerance_device = 1e-9;
constexpr double tolerance_together = 1e-9;

double reference_ln_f(const Parameters& p, const Variant& variant, const DirectionPair& at, double share_s) {
  const auto f = reference::Model(p, variant).brdf(at.theta_i, at.model_theta_s(), at.model_phi());
  return std::log(share_s * f.s.total() + (1 - share_s) * f.p.total());
}

// d/dx by central differences at h, h/2 and h/4, extrapolated twice.
template <class Function>
double slope(const Function& f, double x, double h) {
  const auto central = [&](double step) { return (f(x + step) - f(x - step)) / (2 * step); };
  const double a = central(h);
  const double b = central(h / 2);
  const double c = central(h / 4);
  const double ab = (4 * b - a) / 3;
  const double bc = (4 * c - b) / 3;
  return (16 * bc - ab) / 15;
}

TEST(Gradients, EqualDifferencesOfTheReference) {
  RandomMaterials random(31);
  int compared = 0;
  for (int k = 0; k < 60; ++k) {
    Parameters p = random.plausible();
    const double share_s = k % 3 == 0 ? 1 : k % 3 == 1 ? 0 : 0.5;
    const DirectionPair at{random.uniform(0, 80), random.uniform(0, 80), random.uniform(-180, 180), 0};
    Variant variant;
    if (k % 4 == 3) {
      variant = random.variant();
      variant.autocovariance = Autocovariance::lorentzian;
      if (variant.normalization == Normalization::closed_form)
        variant.normalization = Normalization::reciprocal;
    }
    SCOPED_TRACE(fmt::format("{}{} share_s={} theta_i={} theta_s={} phi={}", text_of(p), text_of(variant),
                             share_s, at.theta_i, at.theta_s, at.phi));
    const auto gradient = Double::log_brdf_gradient(p, variant, at, share_s);
    EXPECT_NEAR(gradient[0], reference_ln_f(p, variant, at, share_s), tolerance_ln_f);
    for (std::size_t c = 0; c < parameter_table.size(); ++c) {
      const auto& row = parameter_table[c];
      const double value = p.*row.member;
      // Kinks of |r| at a critical or Brewster angle lie within the differences' reach only if that is wide.
      const double h = 4e-3 * std::max(value, 0.05);
      if (value - h < row.minimum) continue;
      const auto f = [&](double x) {
        Parameters moved = p;
        moved.*row.member = x;
        return reference_ln_f(moved, variant, at, share_s);
      };
      const double expected = slope(f, value, h);
      EXPECT_NEAR(gradient[c + 1], expected,
                  tolerance_slope * (std::abs(expected) + 1 / std::max(value, 0.05)))
          << row.name << " = " << value;
      ++compared;
    }
    if (HasFailure()) return;
  }
  EXPECT_GT(compared, 600);
}

TEST(Gradients, OfNormalizationEqualDifferencesOfTheReference) {
  RandomMaterials random(32);
  for (int k = 0; k < 40; ++k) {
    const Parameters p = random.plausible();
    const double theta_i = k % 8 == 0 ? 0 : random.uniform(0, 89);
    SCOPED_TRACE(fmt::format("{}theta_i={}", text_of(p), theta_i));
    const auto gradient = Double::log_normalization_gradient(p, Lobe::surface, theta_i);
    const auto ln_n = [&](double Parameters::*member, double x) {
      Parameters moved = p;
      moved.*member = x;
      return std::log(reference::Model(moved).normalization(Lobe::surface, theta_i).value);
    };
    EXPECT_NEAR(gradient[0], ln_n(&Parameters::n, p.n), 1e-10);
    EXPECT_NEAR(gradient[1],
                p.rho_surface * slope([&](double x) { return ln_n(&Parameters::rho_surface, x); },
                                      p.rho_surface, 4e-3 * p.rho_surface),
                1e-7);
    EXPECT_NEAR(gradient[2], p.w * slope([&](double x) { return ln_n(&Parameters::w, x); }, p.w, 4e-3 * p.w),
                1e-7);
    if (p.n > 0.1) {
      EXPECT_NEAR(gradient[3], slope([&](double x) { return ln_n(&Parameters::n, x); }, p.n, 2e-3 * p.n),
                  1e-7);
    }
    if (HasFailure()) return;
  }
}

TEST(Gradients, OnTheDeviceEqualTheSameSourceInCpp) {
  const Device device = select_device(std::nullopt);
  if (!device.has_fp64) GTEST_SKIP() << "the device has no fp64";
  const Engine engine(device, Precision::float64, Precision::float32);
  RandomMaterials random(33);
  std::vector<DirectionPair> pairs;
  std::vector<double> share_s;
  for (int k = 0; k < 67; ++k) {
    pairs.push_back({10. * (k % 9), random.uniform(-85, 85), k % 2 ? 0 : random.phi(), 0});
    share_s.push_back(0.5 * (k % 3));
  }
  std::vector<Parameters> materials;
  for (int k = 0; k < 5; ++k) materials.push_back(random.plausible());
  for (const Normalization normalization : {Normalization::hemispherical, Normalization::reciprocal}) {
    Variant variant;
    variant.normalization = normalization;
    const LogBrdfGradients gradients(engine, pairs, share_s, variant);
    const LogBrdfValues values = gradients.evaluate(materials);
    for (std::size_t m = 0; m < materials.size(); ++m)
      for (std::size_t k = 0; k < pairs.size(); ++k) {
        const auto expected = Double::log_brdf_gradient(materials[m], variant, pairs[k], share_s[k]);
        EXPECT_NEAR(values.ln_f(m)[k], expected[0], tolerance_device);
        for (std::size_t c = 0; c < parameter_table.size(); ++c)
          EXPECT_NEAR(values.by(m, c)[k], expected[c + 1], tolerance_device * (1 + std::abs(expected[c + 1])))
              << parameter_table[c].name << " of " << text_of(materials[m]) << " at pair " << k;
        if (HasFailure()) return;
      }
  }
}

// Angles close together share nodes of N: whatever the company, a direction's values are those that it has
// alone.
TEST(Gradients, ManyCloseAnglesGiveWhatEachGivesAlone) {
  if (!select_device(std::nullopt).has_fp64) GTEST_SKIP() << "the device has no fp64";
  const Engine engine(select_device(std::nullopt), Precision::float64, Precision::float32);
  RandomMaterials random(34);
  std::vector<Parameters> materials;
  for (int k = 0; k < 40; ++k) materials.push_back(random.plausible());
  // The angles are eight settings read back from an encoder, a scan in tenths of a degree, and single ones up
  // to grazing.
  std::vector<DirectionPair> pairs;
  for (int k = 0; k < 240; ++k)
    pairs.push_back({10. * (k % 8) + random.uniform(0, 0.1), random.uniform(0, 80), 180. * (k % 2), 0});
  for (int k = 0; k < 300; ++k) pairs.push_back({55 + 0.1 * k, random.uniform(0, 80), 0, 0});
  for (const double theta : {85.3, 87., 89.}) pairs.push_back({theta, 40, 0, 0});
  for (const Normalization normalization : {Normalization::hemispherical, Normalization::reciprocal}) {
    Variant variant;
    variant.normalization = normalization;
    const LogBrdfValues together = LogBrdfGradients(engine, pairs, 0.5, variant).evaluate(materials);
    double worst = 0;
    for (std::size_t k = 0; k < pairs.size(); k += 7) {
      const LogBrdfValues alone = LogBrdfGradients(engine, {&pairs[k], 1}, 0.5, variant).evaluate(materials);
      for (std::size_t m = 0; m < materials.size(); ++m) {
        const double error = std::abs(together.ln_f(m)[k] - alone.ln_f(m)[0]);
        worst = std::max(worst, error);
        EXPECT_LE(error, tolerance_together) << text_of(materials[m]) << " theta_i=" << pairs[k].theta_i;
        for (std::size_t p = 0; p < parameter_table.size(); ++p) {
          const double value = materials[m].*parameter_table[p].member;
          const double scale = std::abs(alone.by(m, p)[0]) + 1 / std::max(value, 0.05);
          // At n = 0 the derivative by n is itself not smooth in the angle beyond eight digits.
          const bool is_rough = parameter_table[p].name == "n" && value == 0;
          EXPECT_NEAR(together.by(m, p)[k], alone.by(m, p)[0],
                      (is_rough ? tolerance_slope : tolerance_together) * scale)
              << parameter_table[p].name << " of " << text_of(materials[m])
              << " theta_i=" << pairs[k].theta_i;
        }
      }
    }
    RecordProperty(normalization == Normalization::reciprocal ? "reciprocal" : "hemispherical",
                   fmt::format("{:.2g}", worst));
  }
}

TEST(Gradients, OfTheMeanOfExchangesEqualDifferencesOfIt) {
  const Device device = select_device(std::nullopt);
  if (!device.has_fp64) GTEST_SKIP() << "the device has no fp64";
  const Engine engine(device, Precision::float64, Precision::float32);
  RandomMaterials random(34);
  const std::vector<DirectionPair> pairs{{20, 60, 30, 0}, {70, -35, 10, 0}, {0, 80, 0, 0}};
  const LogBrdfGradients gradients(engine, with_exchanges(pairs), 0.5);
  for (int k = 0; k < 4; ++k) {
    const Parameters p = random.plausible();
    const LogBrdfValues values = gradients.evaluate({&p, 1}).mean_of_exchanges(1);
    ASSERT_EQ(values.ln_f(0).size(), pairs.size());
    for (std::size_t j = 0; j < pairs.size(); ++j) {
      const auto ln_mean = [&](const Parameters& moved) {
        const double theta_i = pairs[j].theta_i, theta_s = pairs[j].model_theta_s(),
                     phi = pairs[j].model_phi();
        return std::log(0.5 * (std::exp(reference_ln_f(moved, {}, {theta_i, theta_s, phi, 0}, 0.5)) +
                               std::exp(reference_ln_f(moved, {}, {theta_s, theta_i, phi, 0}, 0.5))));
      };
      EXPECT_NEAR(values.ln_f(0)[j], ln_mean(p), tolerance_ln_f);
      for (std::size_t c = 0; c < parameter_table.size(); ++c) {
        const auto& row = parameter_table[c];
        const double value = p.*row.member, h = 4e-3 * std::max(value, 0.05);
        if (value - h < row.minimum) continue;
        const auto moved_to = [&](double x) {
          Parameters moved = p;
          moved.*row.member = x;
          return ln_mean(moved);
        };
        const double expected = slope(moved_to, value, h);
        EXPECT_NEAR(values.by(0, c)[j], expected,
                    tolerance_slope * (std::abs(expected) + 1 / std::max(value, 0.05)))
            << row.name << " = " << value << " at pair " << j;
      }
    }
  }
}

}  // namespace
}  // namespace brdftab

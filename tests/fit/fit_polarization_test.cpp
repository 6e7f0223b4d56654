// Measurements in polarised light: which samples are taken, and that each is fitted in its own light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "host/base/error.hpp"
#include "host/fit/fit_summary.hpp"
#include "host/formats/read_measurement.hpp"
#include "host/formats/text/csv_measurement.hpp"
#include "host/model/material.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/reference/model.hpp"
#include "tests/fit/fit_device.hpp"

namespace brdftab {
namespace {

// As `evaluate` writes it: columns brdf_s, brdf_p and brdf of brown vinyl, without noise.
const std::filesystem::path polarised_data =
    std::filesystem::path(BRDFTAB_TESTS_DIR) / "data" / "polarised" / "sp.csv";

constexpr Parameters paint{1.5, 0.3, 0.8, 0.25, 0.3, 1.2, 0.1, 0.3, 0.3, 0.3, 2, 1, 1, 4};

// f of s and of p in plane, in the order of a CSV reader; `noise`: standard deviation of ln f.
void add_polarised(Measurement& measurement, const Parameters& truth, std::size_t channel, double noise,
                   std::mt19937_64& random) {
  const reference::Model model(truth);
  std::normal_distribution<double> normal;
  for (double theta_i = 0; theta_i <= 80; theta_i += 20)
    for (double theta_s = -80; theta_s <= 80; theta_s += 5) {
      const DirectionPair pair{theta_i, theta_s, 0, measurement.samples.size() + 1};
      const auto f = model.brdf(theta_i, pair.model_theta_s(), pair.model_phi());
      for (const auto& [light, value] :
           {std::pair{Polarization::s, f.s.total()}, {Polarization::p, f.p.total()}})
        measurement.samples.push_back({.pair = pair,
                                       .brdf = value * std::exp(noise * normal(random)),
                                       .channel = channel,
                                       .share_s = share_s(light)});
    }
}

std::string refusal(const std::string& columns, const std::string& light) {
  try {
    std::istringstream in("theta_i_deg,theta_s_deg,phi_deg," + columns + "\n10,20,0,0.1" +
                          (columns.find(',') == std::string::npos ? "\n" : ",0.2\n"));
    Measurement measurement = read_csv_measurement(in, "data.csv");
    choose_light(measurement, light_named(light), true);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

class FitPolarization : public OnFitDevice {
 protected:
  static FitOptions options(std::size_t starts) {
    FitOptions result;
    result.starts = starts;
    result.floor = 0;
    return result;
  }
  // Widths of the 95 % intervals of ln n_eff and of k_eff's own variable.
  static std::array<double, 2> widths(const Measurement& measurement) {
    FitProblem problem(engine(), measurement, options(8));
    const Fit best = fit(problem);
    const LinearUncertainty linear = linear_uncertainty(problem, best.best);
    return {linear.standard_error(0), linear.standard_error(1)};
  }
};

TEST(MeasuredLight, RefusesAColumnThatIsNotThereAndNamesThoseThatAre) {
  EXPECT_EQ(refusal("brdf_s,brdf_p", "s"), "accepted");
  EXPECT_EQ(refusal("brdf_s_per_sr,brdf_p_per_sr", "all"), "accepted");
  EXPECT_EQ(refusal("brdf_s,brdf_p", "unpolarized"), "accepted");
  EXPECT_EQ(refusal("brdf_per_sr", "unpolarized"), "accepted");
  for (const auto& [columns, light, missing, there] :
       {std::array{"brdf_s", "p", "brdf_p", "brdf_s (s-polarised)"},
        {"brdf_s", "unpolarized", "brdf ", "brdf_s (s-polarised)"},
        {"brdf_s", "all", "brdf_p", "brdf_s (s-polarised)"},
        {"brdf_p,brdf", "s", "brdf_s", "brdf (unpolarised), brdf_p (p-polarised)"},
        {"brdf_per_sr", "s", "brdf_s", "brdf (unpolarised)"},
        {"brdf_per_sr", "all", "brdf_s", "brdf (unpolarised)"}}) {
    const std::string message = refusal(columns, light);
    EXPECT_NE(message.find(std::string("data.csv: has no column ") + missing), std::string::npos) << message;
    EXPECT_NE(message.find(there), std::string::npos) << message;
  }
  EXPECT_NE(refusal("brdf_x", "s").find("brdf_per_sr is missing"), std::string::npos);
}

TEST(MeasuredLight, UnpolarisedIsTheMeanOfSAndPWhereOnlyTheyAreThere) {
  std::istringstream in(
      "theta_i_deg,theta_s_deg,phi_deg,brdf_s,brdf_p,sigma_s,sigma_p\n10,20,0,0.1,0.2,0.03,0.04\n10,21,0,nan,"
      "0.2,0.03,0.04\n");
  Measurement measurement = read_csv_measurement(in, "data.csv");
  ASSERT_EQ(measurement.samples.size(), 4u);
  choose_light(measurement, light_named("unpolarized"), true);
  ASSERT_EQ(measurement.samples.size(), 2u);
  EXPECT_DOUBLE_EQ(measurement.samples[0].brdf, 0.15);
  EXPECT_DOUBLE_EQ(measurement.samples[0].sigma, 0.025);
  EXPECT_EQ(measurement.samples[0].share_s, 0.5);
  EXPECT_TRUE(std::isnan(measurement.samples[1].brdf));
  ASSERT_EQ(measurement.warnings.size(), 1u);
}

TEST_F(FitPolarization, EveryLightGivesTheMaterialBack) {
  const Parameters truth = Material::read(std::filesystem::path(BRDFTAB_MATERIALS_DIR) / "brown-vinyl.toml")
                               .bands()
                               .front()
                               .parameters;
  for (const char* light : {"s", "p", "unpolarized", "all"}) {
    const Measurement measurement =
        read_measurement(polarised_data, {.format = "", .light = light_named(light)});
    FitProblem problem(engine(), measurement, options(16));
    EXPECT_EQ(problem.samples(), light == std::string("all") ? 656u : 328u);
    const Fit best = fit(problem);
    EXPECT_NEAR(problem.parameters(best.best.u)[0].n_eff, truth.n_eff, 1e-4 * truth.n_eff) << light;
    EXPECT_LT(problem.log_rms(best.best.u).of_samples, 1e-5) << light;
  }
}

TEST_F(FitPolarization, SAndPTogetherTellTheIndexBetterThanTheirMean) {
  std::mt19937_64 random(21);
  Measurement both{.source = "polarised", .channels = {""}, .samples = {}, .warnings = {}};
  add_polarised(both, paint, 0, 0.03, random);
  Measurement mean = both;
  choose_light(mean, light_named("unpolarized"), true);
  ASSERT_EQ(2 * mean.samples.size(), both.samples.size());
  const auto joint = widths(both), unpolarised = widths(mean);
  EXPECT_LT(joint[0], 0.7 * unpolarised[0]);
  EXPECT_LT(joint[1], 0.7 * unpolarised[1]);
}

TEST_F(FitPolarization, BandsHaveBothLights) {
  Parameters red = paint;
  red.n_eff = 1.7;
  red.sigma_bulk = 0.5;
  std::mt19937_64 random(22);
  Measurement both{.source = "polarised", .channels = {"450", "650"}, .samples = {}, .warnings = {}};
  add_polarised(both, paint, 0, 0, random);
  add_polarised(both, red, 1, 0, random);
  FitProblem problem(engine(), both, options(12));
  EXPECT_FALSE(problem.is_of_one_light());
  const auto bands = problem.parameters(fit(problem).best.u);
  EXPECT_NEAR(bands[0].n_eff, paint.n_eff, 0.01);
  EXPECT_NEAR(bands[1].n_eff, red.n_eff, 0.01);
  EXPECT_NEAR(bands[1].sigma_bulk / bands[0].sigma_bulk, 0.5 / 0.3, 0.01);
}

}  // namespace
}  // namespace brdftab

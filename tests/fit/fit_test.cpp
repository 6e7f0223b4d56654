// Fits to measurements made by the scalar reference: what is found again, what is told of it, what is
// refused.
#include "host/fit/fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "bench/synthetic.hpp"
#include "host/base/error.hpp"
#include "host/base/statistics.hpp"
#include "host/fit/fit_summary.hpp"
#include "host/fit/uncertainty/fit_profile.hpp"
#include "tests/fit/fit_device.hpp"
#include "tests/random_materials.hpp"

namespace brdftab {
namespace {

// All terms of this material matter, and none of its parameters is at a bound.
constexpr Parameters paint{1.5, 0.3, 0.8, 0.25, 0.3, 1.2, 0.1, 0.3, 0.3, 0.3, 2, 1, 1, 4};

class FitTest : public OnFitDevice {
 protected:
  static FitOptions options(std::size_t starts = 16) {
    FitOptions result;
    result.starts = starts;
    result.floor = 0;
    return result;
  }
  std::mt19937_64 random{5};
};

TEST_F(FitTest, RecoversNoiseFreeDataAndEveryParameter) {
  FitProblem problem(engine(), synthetic_measurement(paint, 10, 4, 0, random), options());
  const Fit found = fit(problem);
  for (const double residual : problem.residuals(found.best.u).values) EXPECT_LE(std::abs(residual), 1e-6);
  const Parameters fitted = problem.parameters(found.best.u)[0];
  for (const auto& row : parameter_table)
    EXPECT_NEAR(fitted.*row.member, paint.*row.member, 1e-3 * (paint.*row.member)) << row.name;
}

TEST_F(FitTest, ResidualsAndTheirDerivativesAgreeWithAnyLossAndWeights) {
  Measurement measurement = synthetic_measurement(paint, 20, 20, 0.1, random);
  for (auto& sample : measurement.samples) sample.sigma = 0.1 * sample.brdf * (1 + sample.pair.theta_i / 40);
  for (const FitWeights weights : {FitWeights::aoi, FitWeights::uniform, FitWeights::sigma}) {
    FitOptions choice = options();
    choice.weights = weights;
    FitProblem problem(engine(), measurement, choice);
    std::vector<double> u = problem.solver_variables(std::vector{paint});
    problem.update_loss_scale(u);
    double sum = 0;
    for (const double weight : problem.bands()[0].weights) sum += weight;
    EXPECT_NEAR(sum / static_cast<double>(problem.samples()), 1, 1e-12);
    const auto at = problem.residuals(u);
    for (std::size_t v = 0; v < u.size(); ++v) {
      const double h = 1e-5;
      auto plus = u;
      auto minus = u;
      plus[v] += h;
      minus[v] -= h;
      const auto up = problem.residuals(plus).values;
      const auto down = problem.residuals(minus).values;
      for (std::size_t k = 0; k < up.size(); ++k)
        EXPECT_NEAR(at.jacobian[k * u.size() + v], (up[k] - down[k]) / (2 * h),
                    weights == FitWeights::sigma ? 2e-5 : 2e-6)
            << problem.variables()[v].row().name;
    }
  }
}

TEST_F(FitTest, SameSeedSameResultWhateverTheCompany) {
  const Measurement measurement = synthetic_measurement(paint, 20, 8, 0.03, random);
  FitProblem once(engine(), measurement, options(8));
  FitProblem again(engine(), measurement, options(8));
  EXPECT_EQ(fit(once).best.u, fit(again).best.u);
}

TEST_F(FitTest, HoldsFixedParametersAndBounds) {
  FitOptions choice = options(8);
  fix_parameter(choice.choices, "k_eff=0.3");
  bound_parameter(choice.choices, "rho_surface=0.3:2");
  FitProblem problem(engine(), synthetic_measurement(paint, 20, 8, 0, random), choice);
  const Fit found = fit(problem);
  const Parameters fitted = problem.parameters(found.best.u)[0];
  EXPECT_EQ(fitted.k_eff, 0.3);
  EXPECT_GE(fitted.rho_surface, 0.3);
  EXPECT_EQ(problem.variables().size(), 13u);
}

TEST_F(FitTest, IntervalsCoverTheTruthAndFlagWhatDataCannotTell) {
  // Incidence up to 40 degrees only: gamma and delta act where tan(theta_i) is large.
  Measurement low = synthetic_measurement(paint, 20, 4, 0.03, random);
  std::erase_if(low.samples, [](const auto& sample) { return sample.pair.theta_i > 40; });
  FitProblem problem(engine(), low, options());
  const FitSummary summary = summarize(engine(), problem, fit(problem), true);
  int covered = 0;
  for (std::size_t v = 0; v < 14; ++v) {
    const double truth = paint.*parameter_table[v].member;
    covered += truth >= summary.variables[v].interval.low && truth <= summary.variables[v].interval.high;
  }
  EXPECT_GE(covered, 11);
  const auto named = [&](std::string_view name) {
    return *std::find_if(summary.variables.begin(), summary.variables.end(),
                         [&](const auto& v) { return v.name == name; });
  };
  EXPECT_TRUE(named("gamma").poorly_known());
  EXPECT_FALSE(named("sigma_surface").unidentifiable());
  // Grazing incidence would tell them.
  for (const Sufficiency& entry : summary.sufficiency) {
    if (summary.variables[entry.variable].name == "gamma") {
      EXPECT_GE(entry.helpful_theta_i, 50);
      EXPECT_GT(entry.gain, 1.2);
    }
  }
}

TEST_F(FitTest, AProfileIsWiderThanItsStandardErrorWhereTheModelCurves) {
  FitProblem problem(engine(), synthetic_measurement(paint, 20, 8, 0.03, random), options());
  Fit found = fit(problem);
  const LinearUncertainty linear = linear_uncertainty(problem, found.best);
  EXPECT_EQ(linear.degrees_of_freedom, problem.samples() - 14);
  EXPECT_NEAR(std::sqrt(linear.variance), 0.03, 0.006);
  const auto profile = profile_intervals(problem, found.best);
  const auto straight = linear_intervals(problem, found.best, linear);
  for (std::size_t v = 0; v < 14; ++v) {
    const double value = problem.variables()[v].from_solver(found.best.u[v]);
    EXPECT_LE(profile[v].low, value);
    EXPECT_GE(profile[v].high, value);
    // Both intervals are alike where the parameter is known well.
    if (straight[v].high < 1.2 * straight[v].low) {
      EXPECT_NEAR(profile[v].low, straight[v].low, 0.3 * (value - straight[v].low))
          << problem.variables()[v].row().name;
      EXPECT_NEAR(profile[v].high, straight[v].high, 0.3 * (straight[v].high - value))
          << problem.variables()[v].row().name;
    }
  }
}

TEST_F(FitTest, CauchyLossHardlyMovesWithOutliers) {
  Measurement measurement = synthetic_measurement(paint, 20, 8, 0.01, random);
  for (std::size_t k = 0; k < measurement.samples.size(); k += 12) measurement.samples[k].brdf *= 3;
  FitOptions robust = options(8);
  robust.loss = FitLoss::cauchy;
  FitProblem with(engine(), measurement, robust);
  FitProblem without(engine(), measurement, options(8));
  const auto median_error = [&](FitProblem& problem) {
    auto values = without.residuals(fit(problem).best.u).values;
    for (double& value : values) value = std::abs(value);
    return median(values);
  };
  EXPECT_LT(3 * median_error(with), median_error(without));
}

TEST_F(FitTest, ChannelsShareGeometry) {
  Parameters red = paint;
  red.n_eff = 1.6;
  red.sigma_bulk = 0.5;
  Measurement both = synthetic_measurement(paint, 20, 8, 0, random);
  both.channels = {"450", "650"};
  for (MeasuredSample sample : synthetic_measurement(red, 20, 8, 0, random).samples) {
    sample.channel = 1;
    both.samples.push_back(sample);
  }
  FitProblem problem(engine(), both, options(8));
  EXPECT_EQ(problem.variables().size(), 9u + 2 * 5u);
  const Fit found = fit(problem);
  const auto bands = problem.parameters(found.best.u);
  EXPECT_EQ(bands[0].rho_surface, bands[1].rho_surface);
  EXPECT_NEAR(bands[1].sigma_bulk / bands[0].sigma_bulk, 0.5 / 0.3, 0.01);
}

TEST_F(FitTest, RefusesTooFewSamples) {
  Measurement measurement = synthetic_measurement(paint, 80, 40, 0, random);
  EXPECT_THROW(FitProblem(engine(), measurement, options()), BadInput);
  measurement = synthetic_measurement(paint, 20, 8, 0, random);
  FitOptions choice = options();
  choice.floor = 1e6;
  EXPECT_THROW(FitProblem(engine(), measurement, choice), BadInput);
  choice = options();
  choice.weights = FitWeights::sigma;
  EXPECT_THROW(FitProblem(engine(), measurement, choice), BadInput);
  choice = options();
  choice.variant.autocovariance = Autocovariance::gaussian;
  EXPECT_THROW(FitProblem(engine(), measurement, choice), BadInput);
}

TEST(FitVariable, MapsAndBounds) {
  for (std::size_t p = 0; p < parameter_table.size(); ++p) {
    const FitVariable v{p, {0}, parameter_table[p].minimum, parameter_table[p].maximum};
    for (const double x : {0.06, 0.7, 3., 19.}) {
      const double u = v.to_solver(x);
      EXPECT_NEAR(v.from_solver(u), x, 1e-12 * x);
      EXPECT_NEAR(v.slope(u), (v.from_solver(u + 1e-5) - v.from_solver(u - 1e-5)) / 2e-5, 1e-6 * v.slope(u));
    }
    EXPECT_TRUE(v.at_minimum(parameter_table[p].minimum));
    EXPECT_TRUE(v.at_maximum(parameter_table[p].maximum));
  }
  auto choices = default_choices();
  for (const char* text : {"k_eff", "k_ef=0", "k_eff=x", "k_eff=-1", "k_eff=21"})
    EXPECT_THROW(fix_parameter(choices, text), BadInput);
  for (const char* text : {"w=1", "w=2:1", "w=0:1", "w=1:x"})
    EXPECT_THROW(bound_parameter(choices, text), BadInput);
}

}  // namespace
}  // namespace brdftab

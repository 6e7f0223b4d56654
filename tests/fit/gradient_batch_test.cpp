// Evaluations of many threads in one launch: each gets what it would get alone, and none waits for ever.
#include "host/fit/gradient_batch.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <vector>

#include "tests/fit/fit_device.hpp"

namespace brdftab {
namespace {

constexpr Parameters paint{1.5, 0.3, 0.8, 0.25, 0.3, 1.2, 0.1, 0.3, 0.3, 0.3, 2, 1, 1, 4};

class GradientBatchTest : public OnFitDevice {
 protected:
  static GradientBatch batch() {
    std::vector<DirectionPair> pairs;
    for (double theta_s = -75; theta_s <= 75; theta_s += 15) pairs.push_back({40, theta_s, 0, 0});
    std::vector<LogBrdfGradients> bands;
    bands.emplace_back(engine(), pairs, 0.5, Variant{});
    return GradientBatch(std::move(bands));
  }

  static Parameters paint_of(std::size_t k) {
    Parameters parameters = paint;
    parameters.n_eff += 0.1 * static_cast<double>(k);
    return parameters;
  }

  // f and all derivatives, to be compared bit by bit.
  static std::vector<double> numbers(const std::vector<BandValues>& values) {
    std::vector<double> all(values[0].ln_f().begin(), values[0].ln_f().end());
    for (std::size_t p = 0; p < parameter_table.size(); ++p) {
      const auto by = values[0].by(p);
      all.insert(all.end(), by.begin(), by.end());
    }
    return all;
  }

  static std::vector<double> evaluated(const GradientBatch& batch, std::size_t k) {
    const Parameters parameters = paint_of(k);
    return numbers(batch.evaluate({&parameters, 1}));
  }
};

TEST_F(GradientBatchTest, CompanyDoesNotChangeResults) {
  const GradientBatch together = batch(), alone = batch();
  constexpr std::size_t items = 9;
  std::vector<std::vector<double>> found(items);
  together.run(items, 4, [&](std::size_t k) {
    // Some threads ask once and some three times, so that a launch has changing members.
    for (std::size_t round = 0; round <= 2 * (k % 2); ++round) found[k] = evaluated(together, k);
  });
  for (std::size_t k = 0; k < items; ++k) EXPECT_EQ(found[k], evaluated(alone, k)) << k;
  EXPECT_EQ(together.materials(), 5u + 3 * 4);
}

TEST_F(GradientBatchTest, SeveralRequestsAreThoseOfEach) {
  const GradientBatch several = batch();
  const std::vector<std::vector<Parameters>> requests{{paint_of(0)}, {paint_of(1)}, {paint_of(2)}};
  const auto found = several.evaluate_all(requests);
  ASSERT_EQ(found.size(), requests.size());
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(numbers(found[k]), evaluated(several, k)) << k;
}

TEST_F(GradientBatchTest, AnItemThatThrowsEndsTheRunAndLeavesNobodyWaiting) {
  const GradientBatch failing = batch();
  std::atomic<int> ended = 0;
  EXPECT_THROW(failing.run(3, 3,
                           [&](std::size_t k) {
                             if (k == 1) throw std::runtime_error("no");
                             evaluated(failing, k);
                             ++ended;
                           }),
               std::runtime_error);
  EXPECT_LE(ended, 2);
  EXPECT_EQ(evaluated(failing, 0), evaluated(batch(), 0));
}

TEST_F(GradientBatchTest, AnItemOfOneBatchMayEvaluateAnother) {
  const GradientBatch outer = batch(), inner = batch();
  std::vector<std::vector<double>> found(4);
  outer.run(found.size(), found.size(), [&](std::size_t k) {
    const auto first = evaluated(inner, k);
    found[k] = evaluated(outer, k);
    EXPECT_EQ(first, found[k]);
  });
  for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(found[k], evaluated(inner, k)) << k;
}

TEST_F(GradientBatchTest, AnItemOfOneBatchMayRunAnother) {
  const GradientBatch outer = batch(), inner = batch();
  std::atomic<int> served = 0;
  outer.run(2, 2, [&](std::size_t k) {
    if (k == 0) inner.run(3, 3, [&](std::size_t j) { served += !evaluated(inner, j).empty(); });
    served += !evaluated(outer, k).empty();
  });
  EXPECT_EQ(served, 5);
}

}  // namespace
}  // namespace brdftab

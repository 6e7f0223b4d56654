// Percentiles against counts of the values below them, and the factors between degrees and radians.
#include "host/base/statistics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "host/base/angle.hpp"

namespace brdftab {
namespace {

// Different values, so that each has a rank of its own.
std::vector<double> shuffled(std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k) values.push_back(0.25 * static_cast<double>(k) - 3);
  std::shuffle(values.begin(), values.end(), std::mt19937_64(count));
  return values;
}

std::size_t below(const std::vector<double>& values, double value) {
  return static_cast<std::size_t>(
      std::count_if(values.begin(), values.end(), [&](double v) { return v < value; }));
}

TEST(Statistics, PercentilesHaveTheirShareOfTheValuesBelowThem) {
  for (const std::size_t count : {1u, 2u, 3u, 10u, 99u, 100u, 101u, 1000u}) {
    auto values = shuffled(count);
    for (const std::size_t percent : {0u, 1u, 10u, 50u, 90u, 95u, 99u}) {
      EXPECT_EQ(below(values, percentile(values, percent)), count * percent / 100)
          << count << ", " << percent;
      EXPECT_EQ(below(values, lower_percentile(values, percent)), (count - 1) * percent / 100)
          << count << ", " << percent;
    }
    EXPECT_EQ(below(values, percentile(values, 100)), count - 1);
    EXPECT_EQ(below(values, lower_percentile(values, 100)), count - 1);
  }
}

TEST(Statistics, MediansOfEvenNumbersAreOneOfTheTwoInTheMiddle) {
  std::vector<double> values{4, 1, 3, 2};
  EXPECT_EQ(median(values), 3);
  EXPECT_EQ(lower_percentile(values, 50), 2);
  std::vector<double> odd{9, 7, 8};
  EXPECT_EQ(median(odd), 8);
  EXPECT_EQ(lower_percentile(odd, 50), 8);
}

TEST(Statistics, NoValuesGiveZero) {
  std::vector<double> none;
  EXPECT_EQ(percentile(none, 50), 0);
  EXPECT_EQ(percentile(none, 100), 0);
  EXPECT_EQ(lower_percentile(none, 100), 0);
}

TEST(Angle, DegreesAndRadians) {
  EXPECT_EQ(radians(180), std::numbers::pi);
  EXPECT_EQ(degrees(std::numbers::pi), 180);
  EXPECT_DOUBLE_EQ(degrees(radians(37.5)), 37.5);
}

}  // namespace
}  // namespace brdftab

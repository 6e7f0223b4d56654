// Settings of theta_i: what is one of them, and what are several.
#include "host/model/measurement/incidences.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace brdftab {
namespace {

TEST(Incidences, ReadBackAnglesAreOneSetting) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> jitter(-0.02, 0.02);
  std::vector<double> theta_i;
  for (const double setting : {0.05, 10.0, 22.5, 60.0, 60.3})
    for (int k = 0; k < 41; ++k) theta_i.push_back(setting + jitter(random));
  std::shuffle(theta_i.begin(), theta_i.end(), random);
  const Incidences incidences(theta_i, Incidences::usual_width);
  ASSERT_EQ(incidences.size(), 5u);
  const std::vector<double> settings{0.05, 10, 22.5, 60, 60.3};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(incidences.angle(k), settings[k], 0.01 + 1e-12);
  for (const double angle : theta_i) EXPECT_NEAR(incidences.angle(incidences.index(angle)), angle, 0.03);
}

TEST(Incidences, RoundingMakesNoSettings) {
  const std::vector<double> theta_i{60, 60 + 7e-15, 60 - 7e-15, 0.1 + 0.2, 0.3, 45};
  const Incidences incidences(theta_i, Incidences::usual_width);
  EXPECT_EQ(incidences.angles(), (std::vector<double>{0.3, 45, 60}));
  EXPECT_EQ(incidences.index(60 - 7e-15), incidences.index(60 + 7e-15));
}

TEST(Incidences, AWidthOfNothingTellsAllNumbersApart) {
  const std::vector<double> theta_i{60, 60 + 7e-15, 10, 10};
  EXPECT_EQ(Incidences(theta_i, 0).angles(), (std::vector<double>{10, 60, 60 + 7e-15}));
  EXPECT_EQ(Incidences({}, 0.25).size(), 0u);
}

// Each group stays within the width, however dense the scan; a step as wide as the width tells settings
// apart.
TEST(Incidences, AScanInFineStepsIsNoChain) {
  std::vector<double> fine, quarters;
  for (int k = 0; k < 320; ++k) fine.push_back(0.1 * k), quarters.push_back(20 + 0.25 * k);
  const Incidences incidences(fine, 0.25);
  EXPECT_EQ(incidences.size(), 107u);
  for (std::size_t k = 0; k < incidences.size(); ++k) {
    EXPECT_LT(incidences.highest(k) - incidences.lowest(k), 0.25);
    if (k > 0) {
      EXPECT_GT(incidences.lowest(k), incidences.highest(k - 1));
    }
  }
  EXPECT_EQ(Incidences(fine, 0.05).size(), 320u);
  EXPECT_EQ(Incidences(quarters, 0.25).angles(), quarters);
}

// A list that would be too long takes whole settings together.
TEST(Incidences, ManySettingsAreListedTogether) {
  std::vector<double> theta_i;
  for (int k = 0; k < 320; ++k)
    for (const double jitter : {-0.01, 0.0, 0.01}) theta_i.push_back(0.3 * k + jitter);
  const Incidences settings(theta_i, 0.25);
  ASSERT_EQ(settings.size(), 320u);
  const Incidences list = settings.joined(20);
  EXPECT_LE(list.size(), 20u);
  EXPECT_GE(list.size(), 10u);
  for (std::size_t k = 0; k < settings.size(); ++k)
    EXPECT_EQ(list.index(settings.lowest(k)), list.index(settings.highest(k))) << settings.angle(k);
  double sum = 0;
  for (const double angle : theta_i) sum += angle - list.angle(list.index(angle));
  EXPECT_NEAR(sum / static_cast<double>(theta_i.size()), 0, 0.005);
  EXPECT_EQ(settings.joined(320).angles(), settings.angles());
  EXPECT_EQ(Incidences(std::vector<double>{10, 80}, 0).joined(1).size(), 1u);
}

// The closest belong together: a group is not cut where it happens to begin at a stray angle.
TEST(Incidences, JoinsTheClosestFirst) {
  const Incidences incidences(std::vector<double>{9.8, 10.01, 10.0, 10.02, 10.03, 10.04, 10.1}, 0.25);
  ASSERT_EQ(incidences.size(), 2u);
  EXPECT_EQ(incidences.lowest(1), 10.0);
  EXPECT_EQ(incidences.highest(1), 10.1);
}

}  // namespace
}  // namespace brdftab

// Axes: what text becomes which nodes, and what is refused.
#include "host/model/axis.hpp"

#include <gtest/gtest.h>

#include <string>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

std::string refusal(AxisKind kind, std::string_view text) {
  try {
    Axis::parse(kind, text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "";
}

TEST(Axis, RangeHasBothEnds) {
  const Axis axis = Axis::parse(AxisKind::theta_i, "0:85:5");
  ASSERT_EQ(axis.size(), 18u);
  EXPECT_EQ(axis[0], 0);
  EXPECT_EQ(axis[17], 85);
}

TEST(Axis, DecimalStepsGiveTheNearestDoubles) {
  const Axis axis = Axis::parse(AxisKind::theta_s, "0:89.9:0.1");
  ASSERT_EQ(axis.size(), 900u);
  EXPECT_EQ(axis[3], 0.3);
  EXPECT_EQ(axis[6], 0.6);
  EXPECT_EQ(axis[899], 89.9);
}

TEST(Axis, ListsAndSingleAngles) {
  EXPECT_EQ(Axis::parse(AxisKind::phi_i, "30")[0], 30);
  EXPECT_EQ(Axis::parse(AxisKind::phi_s, "-90, 0,90")[0], -90);
  EXPECT_EQ(Axis::parse(AxisKind::phi_s, "-180:180:2").size(), 181u);
}

TEST(Axis, RefusesWhatCannotBeAnAxis) {
  const std::pair<const char*, const char*> cases[] = {
      {"", "no node"},          {"0:90:5", "90 does not"},  {"-1:10:1", "-1 does not"},
      {"0,5,5", "5 follows 5"}, {"5,0", "0 follows 5"},     {"0:10:3", "whole number of steps"},
      {"10:0:1", "increase"},   {"0:10:0", "step"},         {"0:10:-1", "step"},
      {"0:10", "start:stop"},   {"0:10:1:2", "start:stop"}, {"0:x:1", "start:stop"},
      {"abc", "'abc'"},         {"nan", "must lie"},        {"inf", "must lie"},
      {"0:89:1e-9", "at most"}, {"0:inf:1", "start:stop"},  {"1,,2", "not a number"},
  };
  for (const auto& [text, cause] : cases) {
    const std::string message = refusal(AxisKind::theta_i, text);
    EXPECT_NE(message.find(cause), std::string::npos) << text << ": " << message;
    EXPECT_NE(message.find("theta_i"), std::string::npos) << text << ": " << message;
  }
  EXPECT_NE(refusal(AxisKind::phi_s, "-180:181:1").find("360"), std::string::npos);
  EXPECT_NE(refusal(AxisKind::phi_s, "0:361:1"), "");
}

}  // namespace
}  // namespace brdftab

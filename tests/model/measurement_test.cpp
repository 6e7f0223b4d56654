// Measurements as files give them: what is refused, what is set aside and counted, what is warned of.
#include "host/model/measurement/measurement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <sstream>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/read_measurement.hpp"
#include "host/formats/text/csv_measurement.hpp"

namespace brdftab {
namespace {

const std::string header = "theta_i_deg,theta_s_deg,phi_s_deg,brdf_per_sr,channel\n";

Measurement read(const std::string& text) {
  std::istringstream in(text);
  Measurement measurement = read_csv_measurement(in, "data.csv");
  clean(measurement);
  return measurement;
}

std::string refusal(const std::string& text) {
  try {
    read(text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

std::string joined(const std::vector<std::string>& lines) {
  return fmt::format("{}", fmt::join(lines, "\n"));
}

TEST(Measurement, RefusesWhatIsNoMeasurement) {
  EXPECT_NE(refusal("").find("data.csv:1: is empty"), std::string::npos) << refusal("");
  EXPECT_NE(refusal(header).find("no samples"), std::string::npos);
  EXPECT_NE(refusal("theta_i_deg,theta_s_deg,phi_deg\n").find("brdf_per_sr is missing"), std::string::npos);
  EXPECT_NE(refusal(header + "10,20,0,0.1O,a\n").find("data.csv:2: brdf_per_sr = 0.1O"), std::string::npos);
  EXPECT_NE(refusal(header + "10,20,0,inf,a\n").find("brdf_per_sr = inf"), std::string::npos);
  EXPECT_NE(refusal(header + "90,20,0,0.1,a\n").find("theta_i_deg = 90"), std::string::npos);
  EXPECT_NE(refusal(header + "10,-90,0,0.1,a\n").find("theta_s_deg = -90"), std::string::npos);
  EXPECT_NE(refusal(header + "10,20,0,0,a\n").find("no sample has f above 0"), std::string::npos);
  EXPECT_NE(refusal("theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr,sigma\n10,20,0,0.1,0\n").find("sigma = 0"),
            std::string::npos);
}

TEST(Measurement, CountsWhatItSetsAside) {
  const Measurement m =
      read(header +
           "10,20,0,0.1,a\n10,21,0,nan,a\n10,22,0,0,a\n10,23,0,-0.1,a\n10,24,0,-0.2,a\n10,20,0,0.1,a\n"
           "10,20,0,0.2,a\n10,20,0,0.1,b\n");
  EXPECT_EQ(m.samples.size(), 7u);  // readings of 0 and below are kept
  EXPECT_EQ(m.channels, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(m.warnings.size(), 5u) << joined(m.warnings);
  EXPECT_NE(m.warnings[0].find("1 of 8 samples are nan"), std::string::npos);
  EXPECT_NE(m.warnings[1].find("1 of 8 samples are zero"), std::string::npos);
  EXPECT_NE(m.warnings[2].find("2 of 8 samples are negative"), std::string::npos);
  EXPECT_NE(m.warnings[3].find("2 samples have the directions of an earlier one, 1 of them its value too"),
            std::string::npos);
}

// A broad lobe about the mirror direction on a diffuse base, in plane.
std::string scan(double level, double peak, double sign) {
  std::string text = header;
  for (const double theta_i : {20, 60})
    for (double theta_s = -75; theta_s <= 75; theta_s += 5)
      text += fmt::format("{},{},0,{},a\n", theta_i, theta_s,
                          level + peak * std::exp(-std::pow((sign * theta_s - theta_i) / 10, 2)));
  return text;
}

TEST(Measurement, WarnsOfOtherUnits) {
  EXPECT_TRUE(read(scan(0.3, 1, 1)).warnings.empty());
  const auto radiance_factor = read(scan(0.3 * std::numbers::pi, 3, 1)).warnings;
  ASSERT_EQ(radiance_factor.size(), 1u);
  EXPECT_NE(radiance_factor[0].find("`scale` 0.3183"), std::string::npos) << radiance_factor[0];
  const auto percent = read(scan(30, 100, 1)).warnings;
  ASSERT_EQ(percent.size(), 1u);
  EXPECT_NE(percent[0].find("`scale` 0.01"), std::string::npos) << percent[0];
}

TEST(Measurement, WarnsOfReversedAzimuth) {
  const auto warnings = read(scan(0.1, 1, -1)).warnings;
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_NE(warnings[0].find("`flip_azimuth`"), std::string::npos) << warnings[0];
}

TEST(Measurement, WavelengthsAreNumbersOrNumbersWithNm) {
  const Measurement m = read(header + "10,20,0,0.1,550\n10,20,0,0.1,600nm\n10,20,0,0.1,visible\n");
  EXPECT_EQ(m.wavelength_nm(0), 550);
  EXPECT_EQ(m.wavelength_nm(1), 600);
  EXPECT_EQ(m.wavelength_nm(2), std::nullopt);
  EXPECT_EQ(m.channel(1).samples.size(), 1u);
}

TEST(Measurement, ReadsMeasuredFilesWithoutSuspicion) {
  const std::filesystem::path data = std::filesystem::path(BRDFTAB_TESTS_DIR) / "data" / "measured";
  int files = 0;
  for (const auto& file : std::filesystem::directory_iterator(data)) {
    const Measurement m = read_measurement(file.path());
    EXPECT_GT(m.samples.size(), 100u);
    // A warning that suspects the file names a setting.
    for (const auto& warning : m.warnings)
      EXPECT_EQ(warning.find("`"), std::string::npos) << file.path() << ": " << warning;
    ++files;
  }
  EXPECT_EQ(files, 5);
}

}  // namespace
}  // namespace brdftab

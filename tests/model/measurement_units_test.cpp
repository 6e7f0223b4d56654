// Files whose numbers are in other units than their layout's are told, with the option that mends them;
// mended, they equal the right file. Right files are not doubted.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/read_measurement.hpp"
#include "tests/measured_files.hpp"

namespace brdftab {
namespace {

class Units : public testing::Test {
 protected:
  Measurement read(const std::string& format, const std::string& text, MeasurementOptions options = {}) {
    const auto file =
        std::filesystem::path(testing::TempDir()) /
        fmt::format("{}-{}", testing::UnitTest::GetInstance()->current_test_info()->name(), format);
    std::ofstream(file, std::ios::binary) << text;
    options.format = format;
    const Measurement measurement = read_measurement(file, options);
    std::filesystem::remove(file);
    return measurement;
  }
  std::string doubts(const Measurement& m) {
    std::string text;
    for (const auto& warning : m.warnings)
      if (warning.find("`") != std::string::npos) text += warning + "\n";
    return text;
  }
  // The wrong file is told, the right one is not, and the mended file equals the right one.
  void expect_mended(const std::string& format, const std::string& wrong, const std::string& right,
                     const std::string& option, const MeasurementOptions& options) {
    const Measurement as_it_is = read(format, right);
    EXPECT_EQ(doubts(as_it_is), "") << format;
    EXPECT_NE(doubts(read(format, wrong)).find(option), std::string::npos)
        << format << ": " << doubts(read(format, wrong));
    expect_equal(read(format, wrong, options), as_it_is);
  }
  void expect_equal(const Measurement& mended, const Measurement& as_it_is) {
    EXPECT_EQ(doubts(mended), "");
    EXPECT_EQ(mended.channels, as_it_is.channels);
    ASSERT_EQ(mended.samples.size(), as_it_is.samples.size());
    for (std::size_t k = 0; k < mended.samples.size(); ++k) {
      const auto &a = mended.samples[k], &b = as_it_is.samples[k];
      EXPECT_NEAR(a.pair.theta_i, b.pair.theta_i, 2e-6);
      EXPECT_NEAR(a.pair.theta_s, b.pair.theta_s, 2e-6);
      EXPECT_NEAR(std::remainder(a.pair.phi - b.pair.phi, 360), 0, 2e-6);
      EXPECT_NEAR(a.brdf / b.brdf, 1, 1e-7);
      EXPECT_EQ(a.channel, b.channel);
    }
  }
};

MeasurementOptions with_angles(const char* name) { return {.angles = parse_angle_unit(name)}; }
MeasurementOptions with_values(ValueKind kind) { return {.values = kind}; }

TEST_F(Units, AnglesInRadiansAreToldAndMended) {
  const auto rows = in_plane({});
  expect_mended("csv", csv(rows, as_is, radian, radian), csv(rows), "`angles` radians",
                with_angles("radians"));
  const auto wide = in_plane({}, 37.5, 20);
  expect_mended("csv", csv(wide, as_is, radian, radian), csv(wide), "`angles` radians",
                with_angles("radians"));
  expect_mended("zemax", zemax({}, as_is, radian), zemax({}), "`angles` radians", with_angles("radians"));
  expect_mended("csv", csv(rows, as_is, 1, radian), csv(rows), "`angles` azimuth-radians",
                with_angles("azimuth-radians"));
}

TEST_F(Units, AnglesInDegreesWhereTheLayoutHasRadiansNameTheOption) {
  const auto rows = in_plane({});
  for (const auto& [format, wrong, right] :
       {std::tuple{"alta", alta(rows, as_is, 1), alta(rows)}, {"astm", astm(rows, as_is, 1), astm(rows)}}) {
    EXPECT_EQ(doubts(read(format, right)), "");
    try {
      read(format, wrong);
      FAIL() << format;
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("`angles` degrees"), std::string::npos) << error.what();
    }
    expect_equal(read(format, wrong, with_angles("degrees")), read(format, right));
  }
}

TEST_F(Units, AFineScanAboutOneDirectionIsInDegrees) {
  std::string text = "theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n";
  for (double s = -1.5; s <= 1.5; s += 0.05)
    text += fmt::format("1,{:.2f},0,{}\n", s, 1 / (1e-4 + std::pow(s - 1, 2)));
  EXPECT_EQ(doubts(read("csv", text)), "");
}

TEST_F(Units, QuarterTurnsInFewDigitsAreTheRim) {
  const std::string rows = csv(in_plane({}), as_is, radian, radian) + "0.5,1.5708,0,0.1\n0.5,-1.571,0,0.1\n";
  const Measurement m = read("csv", rows, with_angles("radians"));
  EXPECT_EQ(m.warnings, std::vector<std::string>{"2 samples at theta = 90 degrees: set aside"});
  EXPECT_THROW(read("csv", rows + "0.5,1.6,0,0.1\n", with_angles("radians")), BadInput);
}

TEST_F(Units, ReflectanceFactorsAreToldAndMended) {
  const Surface white{0.8, 0.05, 0.25};
  const Change pi_f = [](double f, double) { return std::numbers::pi * f; };
  const Change percent = [](double f, double) { return 100 * std::numbers::pi * f; };
  const auto rows = in_plane(white), dark = in_plane({0.05, 0.3, 0.1});
  expect_mended("csv", csv(rows, pi_f), csv(rows), "`values` pi-f", with_values(ValueKind::pi_f));
  expect_mended("alta", alta(rows, pi_f), alta(rows), "`values` pi-f", with_values(ValueKind::pi_f));
  expect_mended("csv", csv(dark, percent), csv(dark), "`values` percent", with_values(ValueKind::percent));
  expect_mended("astm", astm(rows, percent), astm(rows), "`values` percent", with_values(ValueKind::percent));
  expect_mended("zemax", zemax(white, percent), zemax(white), "`values` percent",
                with_values(ValueKind::percent));
  expect_mended("zemax", zemax(white, pi_f), zemax(white), "`values` pi-f", with_values(ValueKind::pi_f));
  EXPECT_NE(doubts(read("csv", csv(rows, [](double f, double) { return 100 * f; }))).find("`scale` 0.01"),
            std::string::npos);
}

TEST_F(Units, FewSamplesAtEachIncidenceTellPercentToo) {
  const Surface white{0.9, 0.05, 0.25};
  for (const double theta_s : {0., 45.}) {
    const auto rows = one_view(white, theta_s);
    const std::string factor = csv(rows, [](double f, double) { return 100 * std::numbers::pi * f; });
    EXPECT_NE(doubts(read("csv", factor)).find("`values` percent"), std::string::npos)
        << doubts(read("csv", factor));
    const Measurement mended = read("csv", factor, with_values(ValueKind::percent)),
                      right = read("csv", csv(rows));
    ASSERT_EQ(mended.samples.size(), right.samples.size());
    for (std::size_t k = 0; k < right.samples.size(); ++k)
      EXPECT_NEAR(mended.samples[k].brdf / right.samples[k].brdf, 1, 1e-12);
    // What one view cannot tell is said of the right file, and nothing else.
    EXPECT_NE(doubts(right).find("incidences have one direction of view only"), std::string::npos)
        << doubts(right);
    EXPECT_EQ(right.warnings.size(), 1u);
  }
}

TEST_F(Units, LogarithmsAreToldAndMended) {
  const auto rows = in_plane({0.3, 30, 0.05}), faint = in_plane({1e-3, 0.01, 0.2});
  const Change log10 = [](double f, double) { return std::log10(f); };
  const Change ln = [](double f, double) { return std::log(f); };
  const Change decibel = [](double f, double) { return 10 * std::log10(f); };
  expect_mended("csv", csv(rows, log10), csv(rows), "`values` log10", with_values(ValueKind::log10));
  expect_mended("alta", alta(rows, ln), alta(rows), "`values` ln", with_values(ValueKind::ln));
  expect_mended("astm", astm(rows, decibel), astm(rows), "`values` db", with_values(ValueKind::decibel));
  // No sample is above 0: the file is refused, and the message names the settings.
  for (const Change& change : {log10, ln, decibel}) {
    try {
      read("csv", csv(faint, change));
      FAIL();
    } catch (const BadInput& error) {
      EXPECT_NE(std::string(error.what()).find("`values` db"), std::string::npos) << error.what();
    }
  }
  expect_equal(read("csv", csv(faint, decibel), with_values(ValueKind::decibel)), read("csv", csv(faint)));
}

TEST_F(Units, NoiseAboutZeroIsNoLogarithm) {
  std::string text = "theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n";
  unsigned state = 1;
  for (int i = 0; i <= 60; i += 15)
    for (int s = -80; s <= 80; s += 2) {
      state = state * 1664525u + 1013904223u;
      text += fmt::format("{},{},0,{}\n", i, s,
                          0.1 * std::exp(-std::pow((s - i) / 8., 2)) + (state / 4294967296. - 0.55));
    }
  EXPECT_EQ(doubts(read("csv", text)).find("`values`"), std::string::npos) << doubts(read("csv", text));
}

TEST_F(Units, UncertaintiesFollowTheValues) {
  std::string text = "theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr,sigma\n";
  for (int s = -60; s <= 60; s += 5) text += fmt::format("10,{},0,{},0.01\n", s, -1 - 0.01 * std::abs(s));
  const double step = 1e-6;
  for (const ValueKindRow& row : value_kind_table) {
    if (row.kind == ValueKind::brdf || row.kind == ValueKind::pi_f || row.kind == ValueKind::percent)
      continue;
    if (row.kind == ValueKind::cosine_weighted) continue;
    const Measurement m = read("csv", text, {.values = row.kind, .scale = 2});
    for (const auto& [pair, brdf, sigma, channel, share_s] : m.samples) {
      const double value = -1 - 0.01 * pair.model_theta_s();
      const double slope =
          2 * (brdf_of(row.kind, value + step, 0) - brdf_of(row.kind, value - step, 0)) / (2 * step);
      EXPECT_NEAR(sigma / (0.01 * slope), 1, 1e-8) << row.name;
      EXPECT_NEAR(brdf / (2 * brdf_of(row.kind, value, 0)), 1, 1e-12) << row.name;
    }
  }
}

TEST_F(Units, CosineWeightedValuesAreToldAndMended) {
  const Change weighted = [](double f, double theta_s) { return f * std::cos(theta_s * radian); };
  const Surface glossy{0.2, 2, 0.1};
  expect_mended("csv", csv(in_plane({}), weighted), csv(in_plane({})), "`values` cosine-weighted",
                with_values(ValueKind::cosine_weighted));
  expect_mended("astm", astm(in_plane(glossy, 25, 4), weighted), astm(in_plane(glossy, 25, 4)),
                "`values` cosine-weighted", with_values(ValueKind::cosine_weighted));
  expect_mended("zemax", zemax(glossy, weighted), zemax(glossy), "`values` cosine-weighted",
                with_values(ValueKind::cosine_weighted));
}

TEST_F(Units, WavelengthsInOtherUnitsAreToldAndMended) {
  const auto rows = in_plane({});
  const std::string nm = astm(rows, as_is, radian, "450,550");
  expect_mended("astm", astm(rows, as_is, radian, "0.45,0.55"), nm, "`wavelength_unit` um",
                {.wavelength_unit = parse_wavelength_unit("um")});
  expect_mended("astm", astm(rows, as_is, radian, "4.5e-7,5.5e-7"), nm, "`wavelength_unit` m",
                {.wavelength_unit = parse_wavelength_unit("m")});
  // Files that say their unit need no option.
  for (const char* names : {"0.45um,0.55um", "0.45 \u00b5m,0.55 \u03bcm", "4.5e-7m,550e-9m"})
    expect_equal(read("astm", astm(rows, as_is, radian, names)), read("astm", nm));
  const Measurement infrared = read("astm", astm(rows, as_is, radian, "10600,3390"));
  EXPECT_EQ(doubts(infrared), "");
  const Measurement counted = read("astm", astm(rows, as_is, radian, "1,2,3"));
  EXPECT_EQ(doubts(counted), "") << "names, not wavelengths";
}

TEST_F(Units, ColumnsOfWavelengthsSayTheirUnit) {
  const auto text = [](const char* column, const char* first, const char* second, const char* third) {
    std::string result = fmt::format("theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr,{}\n", column);
    for (int s = -60; s <= 60; s += 5)
      result +=
          fmt::format("10,{0},0,0.1,{1}\n10,{0},0,0.2,{2}\n30,{0},0,0.1,{3}\n", s, first, second, third);
    return result;
  };
  const Measurement nm = read("csv", text("wavelength_nm", "450", "550", "450"));
  EXPECT_EQ(nm.channels, (std::vector<std::string>{"450", "550"}));
  expect_equal(read("csv", text("wavelength_um", "0.45", "0.55", "0.450")), nm);
  const std::string wrong = text("wavelength_nm", "0.45", "0.55", "0.45");
  EXPECT_NE(doubts(read("csv", wrong)).find("`wavelength_unit` um"), std::string::npos);
  expect_equal(read("csv", wrong, {.wavelength_unit = parse_wavelength_unit("um")}), nm);
  // A wavelength is one channel, whatever its text.
  for (const char* other : {"450.0", "4.5e2", "450nm", "450 nm", "0.45um"})
    expect_equal(read("csv", text("wavelength_nm", "450", "550", other)), nm);
  EXPECT_EQ(read("csv", text("channel", "450", "R", "450.0")).channels,
            (std::vector<std::string>{"450", "R"}));
  EXPECT_EQ(nm.find_channel("450.00"), 0u);
  EXPECT_EQ(nm.find_channel("0.55um"), 1u);
  EXPECT_EQ(nm.find_channel("551"), std::nullopt);
}

TEST_F(Units, RowsThatDoNotMatchNumPointsAreTold) {
  const auto rows = in_plane({});
  const auto warnings = [&](std::size_t said) {
    return read("astm", astm(rows, as_is, radian, "550nm", said)).warnings;
  };
  EXPECT_TRUE(warnings(rows.size()).empty());
  for (const std::size_t said : {rows.size() + 128, rows.size() - 1}) {
    ASSERT_EQ(warnings(said).size(), 1u);
    EXPECT_NE(warnings(said)[0].find(fmt::format("has {} rows where NUM_POINTS says {}", rows.size(), said)),
              std::string::npos);
  }
}

}  // namespace
}  // namespace brdftab

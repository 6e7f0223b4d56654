// Measurements in other programs' formats: their conventions become theta_i, theta_s and phi = 0 forward, f
// in 1/sr.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <numbers>
#include <sstream>

#include "host/base/error.hpp"
#include "host/formats/merl/merl_measurement.hpp"
#include "host/formats/text/alta_astm_measurement.hpp"
#include "host/formats/zemax/zemax_measurement.hpp"

namespace brdftab {
namespace {

constexpr double radian = std::numbers::pi / 180;

template <class Read>
Measurement read(Read reader, const std::string& text) {
  std::istringstream in(text);
  return reader(in, "data", {});
}

template <class Read>
std::string refusal(Read reader, const std::string& text) {
  try {
    read(reader, text);
  } catch (const BadInput& error) {
    return error.what();
  }
  return "accepted";
}

double cosine_of_phi(const MeasuredSample& sample) { return std::cos(sample.pair.model_phi() * radian); }

TEST(AltaMeasurement, CountsAzimuthFromTheForwardSide) {
  const std::string header = "#DIM 4 1\n#PARAM_IN SPHERICAL_TL_PL_TV_PV\n#PARAM_OUT INV_STERADIAN\n#VS 0\n";
  // Vectors away from the surface: the mirror direction of (30, 10) degrees is (30, 190).
  const auto m =
      read(read_alta_measurement, header + fmt::format("{:.17g} {:.17g} {:.17g} {:.17g} 0.5\n", 30 * radian,
                                                       10 * radian, 30 * radian, 190 * radian));
  ASSERT_EQ(m.samples.size(), 1u);
  EXPECT_EQ(m.samples[0].pair.theta_i, 30);
  EXPECT_NEAR(cosine_of_phi(m.samples[0]), 1, 1e-12);
  EXPECT_EQ(m.samples[0].brdf, 0.5);
}

TEST(AltaMeasurement, TakesTheCosineOutAndKnowsChannels) {
  const auto m = read(read_alta_measurement,
                      "#DIM 3 3\n#PARAM_IN ISOTROPIC_TV_TL_DPHI\n#PARAM_OUT INV_STERADIAN_COSINE_FACTOR\n" +
                          fmt::format("{:.17g} {:.17g} 0 0.1 0.2 0.3\n", 60 * radian, 20 * radian));
  ASSERT_EQ(m.samples.size(), 3u);
  EXPECT_EQ(m.samples[0].pair.theta_i, 20);
  EXPECT_EQ(m.samples[0].pair.theta_s, 60);
  EXPECT_NEAR(cosine_of_phi(m.samples[0]), -1, 1e-12) << "light and view on one side: backward";
  EXPECT_NEAR(m.samples[1].brdf, 0.4, 1e-12);
  EXPECT_EQ(m.channels, (std::vector<std::string>{"R", "G", "B"}));
}

TEST(AltaMeasurement, ReadsProjectedAzimuthsAndSetsTheRimAside) {
  const auto m =
      read(read_alta_measurement,
           "#DIM 3 1\n#PARAM_IN ISOTROPIC_TL_TV_PROJ_DPHI\n#PARAM_OUT INV_STERADIAN\n" +
               fmt::format("{0:.17g} {0:.17g} 0 2\n{0:.17g} {1:.17g} 1e-16 3\n", 15 * radian, -40 * radian) +
               fmt::format("{:.17g} {:.17g} {:.17g} 4\n0.2 -1.57079632679489656 1e-16 5\n", 15 * radian,
                           30 * radian, -40 * radian));
  ASSERT_EQ(m.samples.size(), 3u);
  EXPECT_NEAR(cosine_of_phi(m.samples[0]), -1, 1e-12) << "light and view on one side: backward";
  EXPECT_EQ(m.samples[0].pair.theta_s, 15);
  EXPECT_NEAR(cosine_of_phi(m.samples[1]), 1, 1e-12);
  EXPECT_EQ(m.samples[1].pair.theta_s, 40);
  EXPECT_NEAR(m.samples[2].pair.theta_s, 50, 1e-6) << "sides of 30 and 40 degrees";
  EXPECT_NEAR(cosine_of_phi(m.samples[2]), -0.6, 1e-7);
  ASSERT_EQ(m.warnings.size(), 1u);
  EXPECT_NE(m.warnings[0].find("1 samples at theta = 90 degrees"), std::string::npos) << m.warnings[0];
}

TEST(AltaMeasurement, RefusesOtherParametrisations) {
  EXPECT_NE(refusal(read_alta_measurement, "#DIM 3 1\n#PARAM_IN RUSIN_TH_TD_PD\n0 0 0 1\n")
                .find("data:2: PARAM_IN RUSIN"),
            std::string::npos);
  EXPECT_NE(refusal(read_alta_measurement, "0 0 0 0 1\n").find("data:1: the header must give #DIM"),
            std::string::npos);
  EXPECT_NE(refusal(read_alta_measurement, "#DIM 4 1\n0 0 1.6 0 1\n")
                .find("theta_s = 1.6: must be from 0 to below pi/2 radians; where the file has degrees, "
                      "`angles` degrees"),
            std::string::npos);
  EXPECT_NE(refusal(read_alta_measurement, "#DIM 4 1\n0 0 1 x 1\n").find("data:2: x"), std::string::npos);
}

TEST(AstmMeasurement, ReadsRadiansAndWavelengths) {
  const auto m = read(
      read_astm_measurement,
      "PROVIDER somebody\nNUM_POINTS 1\nVARS theta_i,phi_i,theta_s,phi_s,400nm,550nm\n" +
          fmt::format("{:.17g},0,{:.17g},{:.17g},0.25,0.5\n", 45 * radian, 10 * radian, std::numbers::pi));
  ASSERT_EQ(m.samples.size(), 2u);
  EXPECT_EQ(m.samples[0].pair.theta_i, 45);
  EXPECT_EQ(m.samples[0].pair.theta_s, 10);
  EXPECT_NEAR(cosine_of_phi(m.samples[0]), 1, 1e-12);
  EXPECT_EQ(m.wavelength_nm(1), 550);
  EXPECT_EQ(m.samples[1].brdf, 0.5);
  EXPECT_NE(refusal(read_astm_measurement, "theta_i\n").find("has no line VARS"), std::string::npos);
  EXPECT_NE(refusal(read_astm_measurement, "VARS theta_i,phi_i,theta_s,phi_s,B\n0,0,0,0\n")
                .find("data:2: has 4 numbers"),
            std::string::npos);
}

// A grid gives the normal a value at each azimuth, and that of 0 again at 360 degrees; a goniometer's equal
// readings stay.
TEST(AstmMeasurement, TellsAGridsRepeatsFromReadings) {
  const auto row = [](double theta_s, double phi_s, double brdf) {
    return fmt::format("{:.17g},0,{:.17g},{:.17g},{}\n", 30 * radian, theta_s * radian, phi_s * radian, brdf);
  };
  std::string grid = "VARS theta_i,phi_i,theta_s,phi_s,B\n";
  for (const double phi_s : {0., 90., 180., 270., 360.})
    grid += row(0, phi_s, 0.3) + row(20, phi_s, phi_s == 180 ? 0.5 : 0.2) + row(40, phi_s, 0.2);
  const auto read_grid = [](std::istream& in, const std::string& source, const MeasurementOptions& options) {
    Measurement measurement = read_astm_measurement(in, source, options);
    set_aside_repeats_of_grid(measurement);
    return measurement;
  };
  const auto m = read(read_grid, grid);
  EXPECT_EQ(m.samples.size(), 9u) << "one at the normal, four at each other theta_s";
  ASSERT_EQ(m.warnings.size(), 1u);
  EXPECT_NE(m.warnings[0].find("6 rows repeat"), std::string::npos) << m.warnings[0];
  // A value that differs shows that the rows were read one by one.
  EXPECT_EQ(read(read_grid, grid + row(20, 0, 0.21)).samples.size(), 16u);
}

TEST(ZemaxMeasurement, TurnsSpecularAnglesIntoDirections) {
  const std::string text =
      "# a "
      "comment\nSource\tMeasured\nSymmetry\tPlaneSymmetrical\nSpectralContent\tMonochrome\nScatterType\tBRDF"
      "\n"
      "SampleRotation\t1\n0\nAngleOfIncidence\t1\n40\nScatterAzimuth\t3\n0\t90\t180\nScatterRadial\t3\n0\t20"
      "\t60\n\n"
      "Monochrome\nDataBegin\nTIS\t0.5\n1\t2\t3\n1\t5\t6\n1\t8\t9\nDataEnd\n";
  const auto m = read(read_zemax_measurement, text);
  // Of nine samples, the one 60 degrees beyond the mirror direction lies below the horizon, and two repeat
  // the mirror direction.
  ASSERT_EQ(m.samples.size(), 6u);
  const auto of = [&](double brdf) {
    return *std::find_if(m.samples.begin(), m.samples.end(), [&](const auto& s) { return s.brdf == brdf; });
  };
  EXPECT_NEAR(of(1).pair.theta_s, 40, 1e-6);  // the mirror direction
  EXPECT_NEAR(cosine_of_phi(of(1)), 1, 1e-12);
  EXPECT_NEAR(of(2).pair.theta_s, 20, 1e-6);  // toward the normal
  EXPECT_NEAR(cosine_of_phi(of(2)), 1, 1e-12);
  EXPECT_NEAR(of(3).pair.theta_s, 20, 1e-6);  // and past it
  EXPECT_NEAR(cosine_of_phi(of(3)), -1, 1e-12);
  EXPECT_NEAR(of(8).pair.theta_s, 60, 1e-6);  // away from the normal
  // A right spherical triangle: cos theta_s = cos 20 cos 40.
  EXPECT_NEAR(of(5).pair.theta_s, std::acos(std::cos(20 * radian) * std::cos(40 * radian)) / radian, 1e-5);
  ASSERT_EQ(m.warnings.size(), 2u);
  EXPECT_NE(m.warnings[0].find("2 values repeat that of another azimuth"), std::string::npos)
      << m.warnings[0];
  EXPECT_NE(m.warnings[1].find("1 values above 0 lie below the horizon"), std::string::npos);
  // Readings that differ at radial 0 are information, and so are equal ones of two directions.
  std::string readings = text;
  readings.replace(readings.find("1\t5\t6"), 5, "1.1\t5\t9");
  EXPECT_EQ(read(read_zemax_measurement, readings).samples.size(), 7u);
  EXPECT_NE(refusal(read_zemax_measurement, "ScatterType BTDF\n").find("must be BRDF"), std::string::npos);
  EXPECT_NE(refusal(read_zemax_measurement, text.substr(0, text.size() - 12)).find("ends too early"),
            std::string::npos);
  EXPECT_NE(refusal(read_zemax_measurement, "tensor_file").find("is no keyword"), std::string::npos);
}

using Merl = std::function<double(double theta_h, double theta_d, double phi_d)>;

// A MERL file with f, a function of degrees, at the centres of cells; one of them is invalid.
std::string merl(const Merl& f, int invalid_h, int invalid_d) {
  std::string bytes(12 + 3 * 1458000 * 8, '\0');
  const std::int32_t dimensions[] = {90, 90, 180};
  std::memcpy(bytes.data(), dimensions, 12);
  for (std::size_t c = 0; c < 3; ++c)
    for (int h = 0; h < 90; ++h)
      for (int d = 0; d < 90; ++d)
        for (int phi = 0; phi < 180; ++phi) {
          const double scale = std::array{1., 1.15, 1.66}[c] / 1500;
          const double value = h == invalid_h && d == invalid_d
                                   ? -1
                                   : f((h + 0.5) * (h + 0.5) / 90, d + 0.5, phi + 0.5) / scale;
          std::memcpy(
              bytes.data() + 12 + 8 * (c * 1458000 + static_cast<std::size_t>(phi + 180 * (d + 90 * h))),
              &value, 8);
        }
  return bytes;
}

// f is even in theta_h and theta_d, and so is this; polynomials of ln f between cells are near but not exact.
TEST(MerlMeasurement, ReadsHalfDifferenceAnglesInPlane) {
  const auto f = [](double theta_h, double theta_d, double) {
    return 0.1 + 1e-4 * theta_h * theta_h + 2e-5 * theta_d * theta_d;
  };
  const std::string bytes = merl(f, 29, 50);  // about theta_h = 10, theta_d = 50 degrees
  const auto m = read(read_merl_measurement, bytes);
  EXPECT_EQ(m.channels.size(), 3u);
  EXPECT_TRUE(m.mean_of_exchanges);
  ASSERT_EQ(m.warnings.size(), 1u);
  EXPECT_NE(m.warnings[0].find("invalid"), std::string::npos);
  int compared = 0;
  for (const auto& sample : m.samples) {
    const double theta_h = std::abs(sample.pair.theta_s - sample.pair.theta_i) / 2;
    const double theta_d = std::abs(sample.pair.theta_s + sample.pair.theta_i) / 2;
    EXPECT_NEAR(sample.brdf / f(theta_h, theta_d, 0), 1, 1e-4)
        << sample.pair.theta_i << " " << sample.pair.theta_s;
    ++compared;
  }
  EXPECT_GT(compared, 2000);
  EXPECT_NE(refusal(read_merl_measurement, "short").find("no MERL file"), std::string::npos);
  EXPECT_NE(refusal(read_merl_measurement, bytes.substr(0, 1000)).find("fewer than"), std::string::npos);
}

TEST(MerlMeasurement, TakesDirectionsOfTheHemisphere) {
  const auto f = [](double theta_h, double theta_d, double phi_d) {
    return 0.1 + 1e-4 * theta_h * theta_h +
           2e-5 * theta_d * theta_d * (1 + 0.5 * std::cos(2 * phi_d * radian));
  };
  const std::string bytes = merl(f, 90, 90);
  const auto take = [&](std::uint64_t seed) {
    std::istringstream in(bytes);
    MeasurementOptions options;
    options.merl_samples = 1800;
    options.merl_seed = seed;
    return read_merl_measurement(in, "data", options);
  };
  const Measurement m = take(1);
  ASSERT_EQ(m.samples.size(), 3 * 1800u);
  ASSERT_EQ(m.notes.size(), 1u);
  for (const char* part :
       {"1800 directions over the hemisphere", "1458000 cells", "seed 1", "the mean over about a degree"})
    EXPECT_NE(m.notes[0].find(part), std::string::npos) << m.notes[0];
  EXPECT_TRUE(m.warnings.empty());
  std::size_t polar_cap = 0, uniform = 0, about_mirror = 0, about_retro = 0;
  for (const auto& [pair, brdf, sigma, channel, share_s] : m.samples) {
    // By spherical trigonometry: cos 2 theta_d is the angle between the vectors, and theta_h is the median of
    // their triangle.
    const double i = pair.theta_i * radian, s = pair.theta_s * radian, phi = pair.phi * radian;
    const double theta_d =
        0.5 * std::acos(std::cos(i) * std::cos(s) - std::sin(i) * std::sin(s) * std::cos(phi));
    const double theta_h = std::acos(std::min(1., (std::cos(i) + std::cos(s)) / (2 * std::cos(theta_d))));
    double cosine = 0;
    if (std::sin(theta_h) * std::sin(theta_d) > 1e-9)
      cosine =
          (std::cos(theta_h) * std::cos(theta_d) - std::cos(i)) / (std::sin(theta_h) * std::sin(theta_d));
    if (theta_h > 0.02) {
      EXPECT_NEAR(
          brdf / f(theta_h / radian, theta_d / radian, std::acos(std::clamp(cosine, -1., 1.)) / radian), 1,
          1e-3)
          << pair.theta_i << " " << pair.theta_s << " " << pair.phi;
    }
    if (channel != 0 || pair.theta_i != 40) continue;
    about_mirror += pair.theta_s == 40 && std::abs(pair.phi) < 33;
    about_retro += pair.theta_s == 40 && std::abs(pair.phi) > 147;
    uniform += pair.theta_s != 40;
    polar_cap += pair.theta_s < 40;
  }
  // Of 225 at each incidence: 45 near the mirror and 22 near the retro direction, with few of the others
  // beside them.
  EXPECT_NEAR(static_cast<double>(about_mirror), 47, 3);
  EXPECT_NEAR(static_cast<double>(about_retro), 24, 3);
  // Rings from 2.5 to 37.5 degrees of those up to 82.5, but for ten directions of the ring at 40.
  EXPECT_NEAR(static_cast<double>(polar_cap) / static_cast<double>(uniform + 10), 0.237, 0.02);
  const auto directions = [](const Measurement& measurement) {
    std::vector<double> phi;
    for (const auto& sample : measurement.samples) phi.push_back(sample.pair.phi);
    return phi;
  };
  EXPECT_EQ(directions(m), directions(take(1)));
  EXPECT_NE(directions(m), directions(take(2)));
}

}  // namespace
}  // namespace brdftab

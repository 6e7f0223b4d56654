// Vectors away from the surface and the model's angles.
#include "host/model/surface_vector.hpp"

#include <gtest/gtest.h>

#include <random>

#include "host/reference/direction.hpp"

namespace brdftab {
namespace {

// The reference reduces angles by means of its own.
TEST(SurfaceVector, HasTheReferencesSinesAndCosines) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> azimuth(-720, 720), polar(0, 90);
  const auto compare = [](double theta, double phi) {
    const auto vector = SurfaceVector::from_degrees(theta, phi);
    const auto sine = reference::sin_degrees(theta);
    EXPECT_EQ(vector.x, static_cast<double>(sine * reference::cos_degrees(phi))) << theta << ' ' << phi;
    EXPECT_EQ(vector.y, static_cast<double>(sine * reference::sin_degrees(phi))) << theta << ' ' << phi;
    EXPECT_EQ(vector.z, static_cast<double>(reference::cos_degrees(theta))) << theta << ' ' << phi;
  };
  for (int k = 0; k < 20000; ++k) compare(polar(random), azimuth(random));
  for (int theta = 0; theta <= 90; theta += 15)
    for (int phi = -720; phi <= 720; phi += 15) compare(theta, phi);
}

TEST(SurfaceVector, IsExactAtRightAnglesAndThirtyDegrees) {
  EXPECT_EQ(SurfaceVector::from_degrees(90, 180).z, 0);
  EXPECT_EQ(SurfaceVector::from_degrees(90, 180).x, -1);
  EXPECT_EQ(SurfaceVector::from_degrees(30, 0).x, 0.5);
  EXPECT_EQ(SurfaceVector::from_degrees(90, -90).y, -1);
}

TEST(SurfaceVector, GivesItsAnglesBack) {
  const auto vector = SurfaceVector::from_degrees(89.9999, -120);
  EXPECT_NEAR(vector.theta(), 89.9999, 1e-13);
  EXPECT_NEAR(vector.phi(), -120, 1e-13);
}

}  // namespace
}  // namespace brdftab

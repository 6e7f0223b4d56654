// An RGL file of an isotropic material holds tables over half vectors, as Mitsuba 3, pbrt-v4 and powitacq
// load them. Source: Dupuy and Jakob, "An adaptive parameterization for efficient material acquisition and
// rendering", ACM Trans. Graph. 37 (2018).
//
// A consumer has f cos(theta_o) = S(s) D(u_m) / (4 sigma(u_i)): u_m is the place of the half vector, its
// azimuth seen from the vector i; s is its place under the inverse warp of the density `vndf` at theta_i; S
// is the table `spectra`. The vector i is the one that a path tracer starts from, the viewer's; o is the
// light's. So f is the model's at theta_i = theta_o and theta_s = theta_i, and no reciprocity is asked of it.
#pragma once

#include <cstddef>
#include <vector>

#include "host/formats/rgl/adaptive_warp.hpp"
#include "host/formats/rgl/tensor_file.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {

/// Directions lie on the unit square at x = sqrt(theta / 90 degrees) and y = (phi + 180 degrees) / 360
/// degrees.
struct RglPlace {
  /// Gives the place of a direction whose azimuth counts from `phi_0`, degrees.
  static SquarePoint of(const SurfaceVector& direction, double phi_0);
  static SurfaceVector direction(SquarePoint place);

  static double of_theta(double degrees);
  static double theta(double x);
  /// Gives the solid angle of the square's column at x, divided by its width: a direction's density in x is
  /// its density in solid angle times this.
  static double solid_angle(double x);
};

struct RglContent {
  std::vector<float> theta_i;         // radians
  std::vector<float> wavelengths_nm;  // empty: the channels are R, G, B
  std::size_t channels = 0;
  std::size_t vndf_rows = 0, vndf_columns = 0;
  std::size_t samples = 0;       // of each side of the square of s
  std::vector<float> ndf;        // D: [2][theta], two equal rows
  std::vector<float> sigma;      // [2][theta]
  std::vector<float> vndf;       // [theta_i][phi][theta]
  std::vector<float> luminance;  // [theta_i][s.y][s.x], the density of s that samples are drawn from
  std::vector<float> spectra;    // [theta_i][channel][s.y][s.x]

  SquareTable ndf_table() const { return {ndf, 2, ndf.size() / 2}; }
  SquareTable sigma_table() const { return {sigma, 2, sigma.size() / 2}; }
  AdaptiveWarp vndf_warp() const { return {vndf, vndf_rows, vndf_columns}; }
  SquareTable spectra_table() const { return {spectra, samples, samples}; }

  /// Gives fields of the names and shapes that the consumers ask for.
  TensorFields fields() const;
  /// Throws BadInput `FILE: field NAME: ...` where one is missing or cannot be what it is for.
  static RglContent from_fields(const std::filesystem::path& file, const TensorFields& fields);
};

}  // namespace brdftab

// N over the polar angle, for so many angles that integrating each would cost too much: interpolated between
// integrals.
#pragma once

#include <array>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/model/material.hpp"

namespace brdftab {

/// Ln N is even and analytic in t = artanh(sin theta), which spreads grazing angles as the lobes narrow
/// there. It is interpolated by polynomials through the ten nearest of nodes 0.0237 apart: at 2000 angles up
/// to 89.9999 degrees of each shipped and each reference material, N is within 1e-11.
class NormalizationCurve {
 public:
  /// Which nodes an angle takes, and how much of each: the same for every band.
  struct Stencil {
    static constexpr std::ptrdiff_t width = 10;
    std::ptrdiff_t first;  // below 0 at small angles, where the curve is mirrored
    std::array<double, width> share;
  };

  /// Integrates N at the nodes up to `largest_theta`, degrees, at most 89.9999. Throws BadInput where it is
  /// not finite.
  NormalizationCurve(const Engine& engine, const Band& band, const Variant& variant, double largest_theta);

  /// Of an angle up to `largest_theta`.
  static Stencil stencil(double theta);
  double operator()(std::size_t lobe, const Stencil& stencil) const;

 private:
  std::array<std::vector<double>, 3> log_n_;
};

}  // namespace brdftab

// f at very many directions, for choosing grids and for formats with many: N, which is costly, comes
// from a curve over the polar angle.
#pragma once

#include <boost/math/interpolators/cardinal_cubic_b_spline.hpp>

#include <array>
#include <vector>

#include "host/compute/normalization_curve.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/model/directions.hpp"
#include "host/model/material.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// The brdfs of a table, one for each band and polarisation, over its ranges of polar angles.
class SampledModel {
 public:
  /// Throws BadInput where N is not finite.
  SampledModel(const Engine& engine, const Material& material, const std::vector<Polarization>& polarizations,
               AngleRange theta_i, AngleRange theta_s);

  std::size_t brdfs() const { return bands_.size() * polarizations_.size(); }

  /// f in 1/sr, [brdf][direction].
  std::vector<std::vector<double>> evaluate(const Directions& directions) const;

  /// The largest f over the directions of scatter at a theta_i; the first call looks for them.
  double peak(std::size_t brdf, double theta_i) const;

 private:
  using Spline = boost::math::interpolators::cardinal_cubic_b_spline<double>;

  /// Of a polar angle, 0 to 1: splines are even in it, and so denser towards grazing, where lobes narrow.
  double place(double theta) const;
  double angle(double place) const;
  void evaluate_part(const Directions& directions, std::size_t begin, std::size_t count,
                     std::vector<std::vector<double>>& f) const;
  void find_peaks() const;

  struct OneBand {
    KernelMaterial kernel;
    NormalizationCurve n;
  };

  const Engine& engine_;
  std::vector<Polarization> polarizations_;
  AngleRange theta_i_, theta_s_;
  double last_;
  std::vector<OneBand> bands_;
  bool reciprocal_;                       // N at theta_s counts, too
  mutable std::vector<Spline> log_peak_;  // of each brdf
};

}  // namespace brdftab

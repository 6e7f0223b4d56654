// The plan of a table: on the device, the factors that depend on one angle, from which any slab is computed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/engine.hpp"
#include "host/integrals.hpp"
#include "host/material.hpp"
#include "host/polarization.hpp"
#include "host/slab.hpp"

namespace brdftab {

/// Sizes of structs that stay on the device, in reals: PolarFactors and, its padding included, AzimuthFactors.
inline constexpr std::size_t polar_factors_reals = 8;
inline constexpr std::size_t azimuth_factors_reals = 5;

/// For one band of a material. Borrows the engine, the material and the grid.
class Plan {
 public:
  /// Computes the integrals at every theta_i and the factors of all polar angles. Throws BadInput where N is not finite.
  Plan(const Engine& engine, const Material& material, const Band& band, const Grid& grid);

  const Integrals& integrals() const { return integrals_; }

  /// Enqueues the samples of a slab, [theta_i][phi_i][theta_s][phi_s] in the table's precision, in 1/sr.
  void tabulate(const Slab& slab, Polarization polarization, const cl::Buffer& samples);

  /// Waits for the last `tabulate`; `samples` is its buffer, mapped. Throws BadInput that names the node and the
  /// parameters where a sample is not finite or the table's precision cannot hold a lobe.
  void check(const Slab& slab, std::span<const std::byte> samples);

 private:
  /// Sets azimuths_ for a range of phi_i; returns, where they are to be spread, the azimuth of each (phi_i, phi_s).
  std::vector<int> fold_azimuths(Range phi_i);
  void prepare_azimuths(const Slab& slab);
  void prepare_shadowing(const Slab& slab);
  void tabulate_pairs(const Slab& slab, Polarization polarization);
  void tabulate_rows(const Slab& slab, const cl::Buffer& rows);
  [[noreturn]] void refuse(std::size_t i, std::size_t s, const std::string& where, std::string_view fault, int lobes) const;

  const Engine& engine_;
  const Material& material_;
  const Band& band_;
  const Grid& grid_;
  KernelMaterial kernel_material_;
  bool gaussian_;
  std::size_t coefficients_;  // of a lobe
  Integrals integrals_;
  std::optional<Normalizations> normalization_s_;
  cl::Buffer polar_i_, polar_s_, incidence_shadowing_;

  struct RowsKey {
    Range theta_i, theta_s;
    Polarization polarization;
    bool operator==(const RowsKey&) const = default;
  };

  // Of the last slabs; kept while their ranges stay.
  std::optional<Range> azimuths_phi_i_;
  std::optional<Range> shadowing_theta_s_;
  std::vector<double> azimuths_;  // degrees, [0, 180]
  bool phi_i_by_slab_ = false;    // the rows of all phi_i at once would take too much room
  std::optional<RowsKey> rows_of_;
  bool spread_ = false;  // azimuths are distinct ones, not one row in the table's order
  cl::Buffer azimuth_, sin2_half_, cos2_half_, forward_, azimuth_of_, scatter_shadowing_;
  cl::Buffer pairs_, alarms_, rows_;
  std::size_t pairs_bytes_ = 0, rows_bytes_ = 0;
};

}  // namespace brdftab

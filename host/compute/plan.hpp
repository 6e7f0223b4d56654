// The plan of a table: on the device, the factors that depend on one angle, from which any slab is computed.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "host/compute/integrals.hpp"
#include "host/compute/on_host/kernels_on_host.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/compute/slab.hpp"
#include "host/model/material.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// phi_s - phi_i on even axes: first + (shift[phi_i] + k) step degrees at node k of phi_s.
struct EvenDifferences {
  double first;
  double step;
  std::size_t phi_s;  // nodes
  std::vector<int> shift;

  /// Of all rows together.
  std::size_t nodes() const;

  /// As the model takes it, in [0, 180].
  double at(std::size_t k) const;
};

/// For one band of a material. Borrows the engine, the material and the grid.
class Plan {
 public:
  /// Computes the factors of all polar angles; `integrals` are those at every theta_i. Throws BadInput where
  /// N is not finite.
  Plan(const Engine& engine, const Material& material, const Band& band, const Grid& grid,
       const Integrals& integrals);

  /// Enqueues the samples of a slab, [theta_i][phi_i][theta_s][phi_s] in the table's precision, in 1/sr.
  void tabulate(const Slab& slab, Polarization polarization, const cl::Buffer& samples);

  /// Waits for the last `tabulate`; `samples` is its buffer, mapped. Throws BadInput that names the node and
  /// the parameters where a sample is not finite or the table's precision cannot hold a lobe.
  void check(const Slab& slab, std::span<const std::byte> samples);

 private:
  /// Whether the denominators of Lorentzian lobes range so little over phi that their product stays in a
  /// float's range.
  bool combines(const kernels_on_host::PolarTables& incidence,
                const kernels_on_host::PolarTables& scatter) const;
  void prepare_azimuths(const Slab& slab);
  void prepare_shadowing(const Slab& slab);
  void tabulate_pairs(const Slab& slab, Polarization polarization);
  /// Whether the slab's rows are pieces of longer ones, strips, computed once for all phi_i.
  bool shares_strips(const Slab& slab) const;
  /// `rows`: the first azimuth of each phi_i; `phi_i`: which of them; `nodes_phi_s`: azimuths of a row.
  void tabulate_rows(const Slab& slab, Range phi_i, std::size_t nodes_phi_s, const cl::Buffer& rows,
                     const cl::Buffer& samples);
  [[noreturn]] void refuse(std::size_t i, std::size_t s, const std::string& where, std::string_view fault,
                           int lobes) const;

  const Engine& engine_;
  const Material& material_;
  const Band& band_;
  const Grid& grid_;
  KernelMaterial kernel_material_;
  bool gaussian_;
  const char* samples_kernel_;
  std::optional<EvenDifferences> even_;
  cl::Buffer polar_i_, polar_s_, incidence_shadowing_, normalization_i_, normalization_s_;

  struct StripsKey {
    Range theta_i;
    Polarization polarization;
    bool operator==(const StripsKey&) const = default;
  };

  // Of the last slabs; kept while their ranges stay.
  std::optional<Range> azimuths_phi_i_;
  std::optional<Range> shadowing_theta_s_;
  std::optional<StripsKey> strips_of_;
  std::size_t azimuths_ = 0;  // in the tables below
  cl::Buffer azimuth_, sin2_half_, cos2_half_, rows_, scatter_shadowing_;
  cl::Buffer pairs_, alarms_, strips_;
  std::size_t pairs_bytes_ = 0, strips_bytes_ = 0;
};

}  // namespace brdftab

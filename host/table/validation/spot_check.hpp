// A few nodes of a table, taken while it is made, against the scalar reference.
#pragma once

#include <span>
#include <vector>

#include "host/compute/slab.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {

class SpotCheck {
 public:
  /// Chooses nodes by a fixed seed: few incidences, since each costs the reference an integral.
  SpotCheck(const TableContent& content);

  /// Keeps the chosen nodes that lie in the slab.
  void take(std::size_t polarization, std::size_t band, const Slab& slab, std::span<const std::byte> samples);

  /// Compares what was taken; nodes below 1e-30 1/sr count by their absolute error only and are left out.
  Accuracy compare() const;

 private:
  struct Node {
    std::size_t polarization, band, theta_i, phi_i, theta_s, phi_s;
    double value;
  };

  const TableContent& content_;
  std::vector<Node> nodes_;
};

/// Samples below this are too small for a relative error.
inline constexpr double smallest_compared = 1e-30;

}  // namespace brdftab

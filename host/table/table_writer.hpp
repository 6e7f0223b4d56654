// A table file in the making. One thread at a time may use it.
#pragma once

#include <span>

#include "host/compute/slab.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {

class TableWriter {
 public:
  virtual ~TableWriter() = default;

  /// Samples of a slab in the table's precision, contiguous, [theta_i][phi_i][theta_s][phi_s].
  virtual void write(std::size_t polarization, std::size_t band, const Slab& slab,
                     std::span<const std::byte> samples) = 0;

  /// Writes what is known only at the end, and closes. Throws FileError.
  virtual void finish(const TableFindings& findings) = 0;
};

}  // namespace brdftab

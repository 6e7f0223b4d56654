// The pixels of a map of the hemisphere of scatter directions, in direction cosines.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "host/model/direction_list.hpp"

namespace brdftab {

/// A map is a square that is 2 wide in direction cosines. Its rows run from sin theta_s sin phi = 1
/// downwards.
class HemispherePixels {
 public:
  explicit HemispherePixels(std::size_t side) : side_(side) {}

  std::size_t side() const { return side_; }

  /// The direction in degrees at a pixel's centre. Beyond theta_s = 89.9 it is the one at 89.9 with the same
  /// azimuth, up to two pixels outside the disc; there is none further outside.
  std::optional<DirectionPair> direction(double theta_i, std::size_t row, std::size_t column) const;

  /// The values of a function at every pixel, row by row; nan outside the disc. The function has to be even
  /// in phi: it is evaluated on one half of the map only.
  std::vector<double> values(
      double theta_i,
      const std::function<std::vector<double>(std::span<const DirectionPair>)>& function) const;

 private:
  std::size_t side_;
};

}  // namespace brdftab

#include "host/pictures/hemisphere_pixels.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/angle.hpp"

namespace brdftab {
namespace {

constexpr double outermost = 89.9;  // degrees

}  // namespace

std::optional<DirectionPair> HemispherePixels::direction(double theta_i, std::size_t row,
                                                         std::size_t column) const {
  const double pixel = 2.0 / static_cast<double>(side_);
  const double x = (static_cast<double>(column) + 0.5) * pixel - 1;
  const double y = 1 - (static_cast<double>(row) + 0.5) * pixel;
  const double radius = std::hypot(x, y);
  if (radius > 1 + 2 * pixel) return std::nullopt;
  const double theta_s = radius < 1 ? std::min(std::asin(radius) / radians_per_degree, outermost) : outermost;
  return DirectionPair{theta_i, theta_s, std::atan2(y, x) / radians_per_degree, 0};
}

std::vector<double> HemispherePixels::values(
    double theta_i,
    const std::function<std::vector<double>(std::span<const DirectionPair>)>& function) const {
  std::vector<DirectionPair> pairs;
  std::vector<std::size_t> places;
  for (std::size_t row = 0; row < side_ / 2; ++row)
    for (std::size_t column = 0; column < side_; ++column)
      if (const auto pair = direction(theta_i, row, column)) {
        pairs.push_back(*pair);
        places.push_back(row * side_ + column);
      }
  const auto f = function(pairs);
  std::vector<double> result(side_ * side_, std::nan(""));
  for (std::size_t k = 0; k < places.size(); ++k) {
    const std::size_t row = places[k] / side_, column = places[k] % side_;
    result[places[k]] = result[(side_ - 1 - row) * side_ + column] = f[k];
  }
  return result;
}

}  // namespace brdftab

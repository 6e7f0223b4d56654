// Energy and reciprocity: what the model does not promise, said in numbers.
#pragma once

#include <string>
#include <vector>

#include "host/compute/integrals.hpp"

namespace brdftab {

/// One line for each polarisation whose DHR exceeds 1, with the largest DHR, its angle and its largest lobe.
std::vector<std::string> energy_warnings(const Material& material, const Band& band,
                                         std::span<const double> theta_i, const Dhr& dhr,
                                         const std::vector<Polarization>& polarizations);

/// |ln f(i,s)/f(s,i)| over a grid of direction pairs.
struct Reciprocity {
  std::size_t pairs = 0;  // compared; those that scatter nothing either way are not
  double median = 0;
  double percentile_90 = 0;
  double maximum = 0;
  double theta_i = 0, theta_s = 0, phi = 0;  // degrees, of the maximum
};

/// The grid: polar angles from 5 to 85 degrees by 5, each pair once, and phi from 0 to 180 by 15.
inline constexpr const char* reciprocity_grid =
    "|ln f(i,s)/f(s,i)|, unpolarised, over theta_i < theta_s in 5:85:5 degrees and phi in 0:180:15 degrees";

Reciprocity reciprocity(const Band& band, const Variant& variant);
Reciprocity reference_reciprocity(const Band& band, const Variant& variant);

}  // namespace brdftab

// D of an RGL file is the lobe about the normal as a density of half vectors, and sigma its projected area.
#pragma once

#include <cstddef>
#include <vector>

#include "host/formats/export/export_model.hpp"

namespace brdftab {

/// Gives the mean of bands, sample by sample, of [band][sample].
std::vector<double> mean_of_bands(const std::vector<std::vector<double>>& by_band);

/// Gives densities of half vectors in 1/sr over their polar angle, at nodes evenly over the x of RglPlace,
/// such that the projected area along the normal is 1. They are above 0. Light and viewer are taken 45
/// degrees from the half vector, to either side of the plane that it makes with the normal: so both stay
/// above the horizon, and far from the retro-reflecting lobe. Throws BadInput where f is 0 at all of them.
std::vector<double> half_vector_density(const ExportModel& source, std::size_t nodes);

/// Gives the projected area of such a density as it is seen from polar angles evenly over x.
std::vector<double> projected_area(const std::vector<double>& density, std::size_t nodes);

}  // namespace brdftab

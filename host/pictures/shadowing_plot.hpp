// V_m as a panel, for pictures of materials and of fits.
#pragma once

#include <span>

#include "host/model/parameters.hpp"
#include "host/pictures/drawing/chart.hpp"

namespace brdftab {

/// V_m in the plane of incidence against theta_s, one curve for each theta_i in degrees.
Panel reflectance_shadowing_panel(const Parameters& parameters, std::span<const double> theta_i);

}  // namespace brdftab

// The panel of V_m that the pictures of materials and those of fits share.
#pragma once

#include <span>

#include "host/model/parameters.hpp"
#include "host/pictures/drawing/chart.hpp"

namespace brdftab {

/// Draws V_m of Eq. (13) against theta_s in the plane of incidence, one curve for each theta_i in degrees.
drawing::Panel reflectance_shadowing_panel(const Parameters& parameters, std::span<const double> theta_i);

}  // namespace brdftab

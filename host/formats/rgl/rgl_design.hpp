// The tables of an RGL file are laid out for a material: nodes lie where its reflected light goes.
//
// In a consumer's formula D and sigma may be any positive tables and `vndf` any density, since S makes up for
// them at its nodes: they say how smooth S is between its nodes, and where these lie. Dupuy and Jakob take D
// from retro-reflection, and `vndf` from D. Here D is the lobe about the normal alone, and `vndf` the density
// of the light itself, retro-reflecting lobe and all, together with a density that is even over the
// hemisphere.
#pragma once

#include <cstddef>

#include "host/formats/export/export_model.hpp"
#include "host/formats/rgl/rgl_content.hpp"

namespace brdftab {

/// The numbers of nodes.
struct RglResolution {
  std::size_t theta_i = 90;  // 0 to 89.9 degrees
  std::size_t samples = 96;  // of each side of the square of s
  std::size_t warp_theta = 256;
  std::size_t warp_phi = 129;  // odd: a row lies in the plane of incidence
};

enum class RglChannels { rgb, spectral };

struct RglDesign {
  RglContent content;
  std::size_t negative_colours = 0;  // samples of a colour outside sRGB, written as 0
  std::vector<double>
      scale;  // of f in `spectra`, [theta_i][s.y][s.x]; 0 where the light is below the horizon
};

/// Lays the tables out. A material without bands is grey: it has three equal channels, or a wavelength that
/// stands for all. Light below the horizon is 0.
RglDesign design_rgl(const ExportModel& source, const RglResolution& resolution, RglChannels channels);

/// Gives a layout `luminance` and `spectra` of the source in place of its own; its nodes lie where its own
/// densities put them. Throws BadInput where its channels are not the source's.
RglDesign resampled_rgl(const ExportModel& source, RglContent layout);

}  // namespace brdftab

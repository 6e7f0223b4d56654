// Radiance, WINDOW and EnergyPlus cut a hemisphere into 145 patches, which they call "LBNL/Klems Full".
#pragma once

#include <array>
#include <cstddef>

#include "host/formats/export/export_model.hpp"

namespace brdftab {

/// A band has patches of equal width in azimuth between two polar angles, degrees; the first is centred at
/// azimuth 0.
struct KlemsBand {
  double centre, first, last;
  int patches;

  double width() const { return 360.0 / patches; }
};

inline constexpr std::array<KlemsBand, 9> klems_bands{{{0, 0, 5, 1},
                                                       {10, 5, 15, 8},
                                                       {20, 15, 25, 16},
                                                       {30, 25, 35, 20},
                                                       {40, 35, 45, 24},
                                                       {50, 45, 55, 24},
                                                       {60, 55, 65, 24},
                                                       {70, 65, 75, 16},
                                                       {82.5, 75, 90, 12}}};

inline constexpr std::size_t klems_patches = 145;

/// Gives the index of the first patch of a band.
std::size_t first_patch(std::size_t band);

/// Gives the patch of a direction, degrees. Azimuths are those of the light's travel and of scatter, so that
/// the mirror direction of a patch has the same index.
std::size_t klems_patch(double theta, double phi);

/// f over a pair of patches is its average there, or its value at their centres.
enum class PatchValue { average, centre };

/// Gives [band of the material][scatter patch][incidence patch], 1/sr. An average is weighted by the
/// projected solid angles of both patches. It takes f at nodes of at most 0.5 and 1 degree in theta_s and
/// theta_i, linear between azimuths that lie densest where lobes do. At the centre f is taken at the band's
/// nominal angle.
std::vector<std::vector<double>> klems_matrix(const ExportModel& source, PatchValue value);

}  // namespace brdftab

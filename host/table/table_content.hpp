// What a table says of itself beside its samples, whatever its format.
#pragma once

#include <string>
#include <vector>

#include "host/base/watch.hpp"
#include "host/model/material.hpp"
#include "host/model/polarization.hpp"
#include "host/model/precision.hpp"
#include "host/table/attribute.hpp"
#include "host/table/energy.hpp"
#include "host/table/table_storage.hpp"

namespace brdftab {

inline constexpr const char* program_version = "brdftab " BRDFTAB_VERSION;
inline constexpr const char* paper_reference =
    "I. G. E. Renhorn and G. D. Boreman, Analytical fitting model for rough-surface BRDF, Optics Express 16, "
    "12892 (2008)";
inline constexpr const char* azimuth_convention =
    "phi = phi_s - phi_i; phi = 0 is the forward (specular) side: the mirror direction is theta_s = theta_i, "
    "phi = 0, and retro-reflection is theta_s = theta_i, phi = 180 degrees. phi_i is the azimuth of the "
    "direction in which the incident light travels; for unit vectors that both point away from the surface, "
    "the incident azimuth is phi_i + 180 degrees.";

/// A sample of a table against the scalar reference, measured while the table is made.
struct Accuracy {
  std::size_t nodes = 0;
  double max_relative_error = 0;
  double rms_relative_error = 0;
};

/// The samples' frame; what the integrals and checks add comes at the end.
struct TableContent {
  const Material& material;
  const Grid& grid;        // of the samples that are stored
  const Grid& dense_grid;  // of the table that readers see
  std::vector<Polarization> polarizations;
  Precision precision;
  Precision working;
  TableStorage storage;
  std::string device;
  std::string build_options;
  std::string history;
  Watch watch;
  std::vector<AttributeInfo> grid_choice;  // how the program chose the grid; empty where it was given
};

struct TableFindings {
  std::vector<Integrals> integrals;      // by band
  std::vector<Reciprocity> reciprocity;  // by band
  std::vector<std::string> energy_warnings;
  Accuracy accuracy;
};

}  // namespace brdftab

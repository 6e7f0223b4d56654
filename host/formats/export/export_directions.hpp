// Where a simulator's file is compared with the model: random pairs of directions at which it has samples.
#pragma once

#include "host/formats/export/export_reader.hpp"

namespace brdftab {

/// They are drawn with a fixed seed. Polar angles end at 89.9 degrees, short of where the model does.
struct ExportDirections {
  /// These are uniform in the solid angle of both directions.
  Directions uniform;
  /// These lie within 0.001 to 30 degrees of the mirror direction, and of the retro-reflected one. They are
  /// uniform in the distance's logarithm and moved to where the file has samples; where it has none so near,
  /// there are few or none.
  Directions near_mirror, near_retro;
  /// The ranges that they are drawn from, degrees, and the ranges' share of all pairs of directions above the
  /// surface, by solid angle.
  AngleRange theta_i, theta_s, phi;
  double share = 0;
};

/// Draws `count` uniform ones, and as many about both peaks together.
ExportDirections export_directions(const ExportReader& table, std::size_t count);

}  // namespace brdftab

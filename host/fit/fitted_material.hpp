// The material that a fit makes, with what the fit says about itself.
#pragma once

#include <string>

#include "host/fit/fit_summary.hpp"
#include "host/model/material.hpp"

namespace brdftab {

/// What the user says about the material, and where it comes from.
struct MaterialHeading {
  std::string name, description;
  /// A citation of the measurement.
  std::string source;
  /// The command that made the fit.
  std::string command;
  /// The measurement's file, and the channel where it has several.
  std::string data, channel;
};

/// Parameters have eight significant digits, ends of intervals four. A fit of several bands, whose channels
/// must be wavelengths then, gives a material with bands.
MaterialContent fitted_material(const FitProblem& problem, const FitSummary& summary,
                                const MaterialHeading& heading);

}  // namespace brdftab

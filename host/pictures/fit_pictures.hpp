// The pictures that show a fit: its curves and data, residuals, V_m and correlations.
#pragma once

#include <filesystem>

#include "host/fit/fit_summary.hpp"

namespace brdftab {

/// Writes fit.svg (f in the plane of incidence as the paper's Fig. 3, with the data), residuals.svg,
/// shadowing.svg (V_m as the paper's Fig. 2) and correlations.svg into a folder, and makes the folder where
/// it is missing. A fit of several channels gets fit-, residuals- and shadowing-WAVELENGTH.svg for each of
/// them. Throws FileError where a file cannot be written, or where it exists and `force` is not set.
void write_fit_pictures(const Engine& engine, const FitProblem& problem, const FitSummary& summary,
                        const std::filesystem::path& folder, bool force);

}  // namespace brdftab

// Pictures of a fit, as the paper's Figs. 2 and 3.
#pragma once

#include <filesystem>

#include "host/fit/fit_summary.hpp"

namespace brdftab {

/// Writes fit.svg (f in plane over the data, one curve per incidence), residuals.svg, shadowing.svg (V_m) and
/// correlations.svg into a folder, which is made if need be; with several channels one fit-, residuals- and
/// shadowing-CHANNEL.svg each. Throws FileError where they cannot be written, or exist and `force` is not
/// set.
void write_fit_pictures(const Engine& engine, const FitProblem& problem, const FitSummary& summary,
                        const std::filesystem::path& folder, bool force);

}  // namespace brdftab

// A fit in words, for people to read.
#pragma once

#include <string>
#include <string_view>

#include "host/fit/fit_summary.hpp"

namespace brdftab {

/// Why a fit is not to be used, for everybody to understand; empty where nothing speaks against it.
std::string verdict(const FitProblem& problem, const FitSummary& summary);

/// All that a fit tells: the verdict, where there is one, the samples, a table of the parameters, the
/// residuals by incidence, correlations, and what would tell more.
std::string summary_text(const FitProblem& problem, const FitSummary& summary);

/// Names what the fit makes small: ln(model/data) or (model - data)/sigma.
std::string_view residuals_name(const FitProblem& problem);

}  // namespace brdftab

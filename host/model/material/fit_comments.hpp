// Reads what version 0.1 of `fit` said about itself in comments: `# 95 %: LOW to HIGH; bounds …` behind each
// parameter, and how the intervals were found in the heading. Today's files have it in [fit].
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/model/material.hpp"
#include "host/model/material/fit_record.hpp"

namespace brdftab {

/// None where no comment says anything of a fit. The text is a material's with these bands.
std::optional<FitRecord> fit_in_comments(const std::string& text, const std::vector<Band>& bands);

}  // namespace brdftab

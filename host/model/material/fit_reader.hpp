// Reads what a fit says about itself: [fit], [fit.NAME] and [band.fit.NAME] of a material file.
#pragma once

#include <optional>

#include "host/model/material/fit_record.hpp"
#include "host/model/material/toml_document.hpp"

namespace brdftab {

/// None where the file says nothing of a fit. `bands`: how many the material has, one without [[band]].
/// Throws BadInput as TomlDocument does.
std::optional<FitRecord> read_fit(const TomlDocument& toml, std::size_t bands);

}  // namespace brdftab

// A page about a table: self-contained HTML with pictures, figures and a map that follows a slider.
#pragma once

#include <string>

#include "host/pictures/plot.hpp"

namespace brdftab {

/// Samples that a page carries at most.
inline constexpr std::size_t most_embedded = 1 << 20;

/// The whole file. `origin`: a sentence of plain text, where the table comes from.
std::string report(const Subject& table, const LazyEngine& engine, const std::string& origin);

}  // namespace brdftab

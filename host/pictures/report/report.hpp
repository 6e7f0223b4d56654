// A page about a table: one HTML file with pictures, figures and a map that follows a slider.
#pragma once

#include <string>

#include "host/pictures/plot.hpp"

namespace brdftab {

/// A page carries at most so many samples.
inline constexpr std::size_t most_embedded = 1 << 20;

/// Returns the whole file. `origin` is a sentence of plain text that says where the table comes from.
std::string report(const Subject& table, const LazyEngine& engine, const std::string& origin);

}  // namespace brdftab

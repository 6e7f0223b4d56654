// The part of a report that its reader moves: a map of f at the angle of incidence of a slider, and a cut in
// plane.
#pragma once

#include <string>

#include "host/base/watch.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

/// Both texts are HTML. The scripts hold the samples, and have to come after the section in the page.
struct Explorer {
  std::string section;
  std::string scripts;
};

/// The page carries at most `most` samples of the table; the section says so where that leaves nodes out.
Explorer explorer(const Subject& table, std::size_t most, const Watch& watch);

}  // namespace brdftab

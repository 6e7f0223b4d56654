// What a table file claims to be, rebuilt from it: the material from its text, the axes, and what it
// promises.
#pragma once

#include <string>
#include <vector>

#include "host/model/material.hpp"
#include "host/model/polarization.hpp"
#include "host/model/precision.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {

struct StoredTable {
  Material material;
  Grid grid;
  std::vector<Polarization> polarizations;  // at least one
  Precision precision;
  Precision working;  // of the device that made it
  /// Largest relative error of a sample: of the precision, and of rounding where attributes tell of it.
  double promised;
  /// Attributes that contradict the material's text or are missing: the file has been edited.
  std::vector<std::string> faults;
};

/// Throws Error (exit status 1) that names what makes the file no table: a variable that is missing or has
/// another shape, dimensions in another order, units, an axis that is none.
StoredTable rebuild(const TableInfo& info, const std::string& file);

}  // namespace brdftab

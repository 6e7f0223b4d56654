// A file format that is read as a measured BRDF has such a reader.
#pragma once

#include <istream>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

struct MeasurementReader {
  /// A file that is called so is read by it, unless the user says otherwise.
  std::vector<std::string_view> extensions;
  /// Reads a file's content; `source` is its name, for messages.
  Measurement (*read)(std::istream& in, const std::string& source, const MeasurementOptions& options);
  /// Grids are written in the format too, with every azimuth at the normal and at 0 and 360 degrees.
  bool lists_grids = false;
  /// It says which polarisation a value is of.
  bool tells_light = false;
};

}  // namespace brdftab

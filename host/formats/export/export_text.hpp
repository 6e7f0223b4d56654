// What a simulator's file says of itself in comments: conventions, origin, and the material's whole text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/formats/export/export_reader.hpp"

namespace brdftab {

/// Lines without the mark of a comment: what the values are, program, paper, time and command line, the
/// channels, and the material's text, each of its lines after "| ".
std::vector<std::string> description_lines(const ExportModel& source, ExportChannels channels);

/// The same read back, line by line; lines of others are ignored.
struct Description {
  std::string material_text;
  std::vector<double> wavelengths_nm;
  Illuminant illuminant = Illuminant::d65;

  /// `line` without the mark of a comment.
  void read(std::string_view line);
};

}  // namespace brdftab

// What a simulator's file says of itself in comments: conventions, origin, and the material's whole text.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/formats/export/export_reader.hpp"

namespace brdftab {

/// Gives lines without the mark of a comment. They say what the values are, name the program, the paper, the
/// time and the command line, describe the channels, and hold the material's text, each of its lines after
/// "| ".
std::vector<std::string> description_lines(const ExportModel& source, ExportChannels channels);

/// What such lines say when they are read back, one by one. Lines of other programs are ignored.
struct Description {
  std::string material_text;
  std::vector<double> wavelengths_nm;
  Illuminant illuminant = Illuminant::d65;

  /// Takes a line without the mark of a comment.
  void read(std::string_view line);
};

}  // namespace brdftab

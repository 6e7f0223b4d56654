// Zemax OpticStudio's tabular BSDF is a text of axes, in degrees about the specular direction, and blocks of
// values.
#pragma once

#include <istream>
#include <string>
#include <vector>

namespace brdftab {

struct ZemaxBlock {
  std::string content;         // Monochrome, TristimulusX, ...
  std::vector<double> tis;     // [rotation][incidence]
  std::vector<double> values;  // [rotation][incidence][azimuth][radial]; 1/sr
};

/// Azimuth 0 about the specular direction points to the normal.
struct ZemaxFile {
  std::vector<std::string> comments;  // without the mark
  std::string symmetry;
  std::vector<double> rotation, incidence, azimuth, radial;
  std::vector<ZemaxBlock> blocks;

  /// Throws BadInput SOURCE:LINE where it is no such file, or one of transmission.
  static ZemaxFile read(std::istream& in, const std::string& source);
  /// Gives the file's text.
  std::string text() const;
};

}  // namespace brdftab

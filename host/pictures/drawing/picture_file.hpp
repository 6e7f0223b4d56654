// A picture in a file whose extension says what it is: SVG or PNG.
#pragma once

#include <filesystem>
#include <string>

#include "host/base/partial_file.hpp"

namespace brdftab {

class PictureFile {
 public:
  /// `png_width` in pixels; 0: 2.5 for each unit of the SVG. Throws BadInput for other extensions, FileError
  /// as PartialFile.
  PictureFile(const std::filesystem::path& target, int png_width, bool force);

  /// Writes an SVG file's text, or draws it; the file then has its name. Throws FileError.
  void write(const std::string& svg);

 private:
  std::filesystem::path target_;
  int png_width_;
  PartialFile file_;
};

}  // namespace brdftab

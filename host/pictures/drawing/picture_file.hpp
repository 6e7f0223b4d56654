// The file of a picture: its extension says whether it is SVG or PNG.
#pragma once

#include <filesystem>
#include <string>

#include "host/base/partial_file.hpp"

namespace brdftab::drawing {

class PictureFile {
 public:
  /// `png_width` is in pixels; 0 makes 2.5 pixels for each user unit of the SVG. Throws BadInput for other
  /// extensions, and FileError where PartialFile does.
  PictureFile(const std::filesystem::path& target, int png_width, bool force);

  /// Writes the text of an SVG file, or the PNG drawn from it, and gives the file its name. Throws FileError.
  void write(const std::string& svg);

 private:
  std::filesystem::path target_;
  int png_width_;
  PartialFile file_;
};

}  // namespace brdftab::drawing

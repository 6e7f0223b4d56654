#include "host/pictures/drawing/picture_file.hpp"

#include <cerrno>
#include <fstream>

#include "host/base/error.hpp"
#include "host/pictures/drawing/png.hpp"

namespace brdftab {
namespace {

const std::filesystem::path& checked(const std::filesystem::path& target, int png_width) {
  const std::string extension = target.extension().string();
  if (extension != ".svg" && extension != ".png")
    throw BadInput("{}: a picture's name must end in .svg or .png", target.string());
  if (extension == ".svg" && png_width > 0) throw BadInput("--width: is of a PNG; an SVG has every width");
  return target;
}

}  // namespace

PictureFile::PictureFile(const std::filesystem::path& target, int png_width, bool force)
    : target_(checked(target, png_width)), png_width_(png_width), file_(target, force) {}

void PictureFile::write(const std::string& svg) {
  if (target_.extension() == ".svg") {
    write_whole_file(file_, target_, svg);
  } else {
    const auto bytes = png_of_svg(svg, png_width_);
    write_whole_file(file_, target_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

void write_whole_file(PartialFile& file, const std::filesystem::path& target, std::string_view content) {
  std::ofstream out(file.path(), std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out)
    throw FileError("{}: cannot be written: {}", target.string(), std::generic_category().message(errno));
  file.commit();
}

}  // namespace brdftab

#include "host/pictures/drawing/picture_file.hpp"

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"
#include "host/pictures/drawing/png.hpp"

namespace brdftab::drawing {
namespace {

const std::filesystem::path& checked(const std::filesystem::path& target, int png_width) {
  const std::string extension = target.extension().string();
  if (extension != ".svg" && extension != ".png")
    throw BadInput("{}: a picture's name must end in .svg or .png", target.string());
  if (extension == ".svg" && png_width > 0) throw BadInput("`width`: is of a PNG; an SVG has every width");
  return target;
}

}  // namespace

PictureFile::PictureFile(const std::filesystem::path& target, int png_width, bool force)
    : target_(checked(target, png_width)), png_width_(png_width), file_(target, force) {}

void PictureFile::write(const std::string& svg) {
  if (target_.extension() == ".svg") {
    write_whole(file_, svg);
  } else {
    const auto bytes = png_of_svg(svg, png_width_);
    write_whole(file_, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
}

}  // namespace brdftab::drawing

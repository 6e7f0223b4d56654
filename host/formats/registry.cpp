#include "host/formats/registry.hpp"

#include <algorithm>
#include <ranges>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"

namespace brdftab {
namespace {

constexpr std::size_t beginning_bytes = 4096;

// A format that is kept in files of another one stands below it.
constexpr std::unique_ptr<Format> (*format_makers[])() = {
    make_hdf5_format,          //
    make_exr_format,           //
    make_alta_format,          //
    make_astm_format,          //
    make_bird_format,          //
    make_csv_format,           //
    make_eradiate_format,      //
    make_merl_format,          //
    make_openmaterial_format,  //
    make_radiance_format,      //
    make_rgl_format,           //
    make_ssdd_format,          //
    make_zemax_format,         //
};

}  // namespace

Formats all_formats() {
  Formats formats;
  for (const auto make : format_makers) formats.push_back(make());
  return formats;
}

const Format* find_format(const Formats& formats, std::string_view name) {
  for (const auto& format : formats)
    if (format->traits().name == name) return format.get();
  return nullptr;
}

const Format* format_of_extension(const Formats& formats, std::string_view extension) {
  for (const auto& format : formats) {
    const auto& own = format->traits().extensions;
    if (std::find(own.begin(), own.end(), extension) != own.end()) return format.get();
  }
  return nullptr;
}

const Format* recognised_format(const Formats& formats, const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::exists(file, error)) throw FileError("{}: does not exist", file.string());
  std::string beginning;
  if (!std::filesystem::is_directory(file, error)) beginning = read_beginning(file, beginning_bytes);
  // An Eradiate file is an HDF5 file too: the more special format is asked first.
  for (const auto& format : std::views::reverse(formats))
    if (format->recognises(file, beginning)) return format.get();
  return nullptr;
}

}  // namespace brdftab

#include "host/formats/open_table.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "host/base/error.hpp"
#include "host/formats/exr/exr_reader.hpp"
#include "host/formats/hdf5/hdf5_reader.hpp"

namespace brdftab {
namespace {

using namespace std::string_view_literals;

constexpr std::string_view hdf5_signature = "\x89HDF\r\n\x1a\n"sv;
constexpr std::array<std::string_view, 4> extensions{".h5", ".hdf5", ".nc", ".exr"};
constexpr std::string_view exr_signature = "\x76\x2f\x31\x01"sv;

}  // namespace

std::unique_ptr<TableReader> open_table(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) throw FileError("{}: does not exist", path.string());
  if (std::filesystem::is_directory(path, error)) return open_exr_reader(path);
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError("{}: cannot be read: {}", path.string(), std::generic_category().message(errno));
  std::string start(8, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  if (start.empty()) throw FileError("{}: is empty", path.string());
  if (start == hdf5_signature) return open_hdf5_reader(path);
  if (start.starts_with(exr_signature)) return open_exr_reader(path);
  throw BadInput("{}: is neither an HDF5 nor an OpenEXR file", path.string());
}

bool is_table(const std::filesystem::path& file) {
  if (file == "-") return false;
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return true;
  // What is named as a table and damaged is to be refused as a table.
  if (std::find(extensions.begin(), extensions.end(), file.extension()) != extensions.end()) return true;
  std::ifstream in(file, std::ios::binary);
  std::string start(hdf5_signature.size(), '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return start == hdf5_signature || start.starts_with(exr_signature);
}

}  // namespace brdftab

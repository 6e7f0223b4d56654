#include "host/base/whole_file.hpp"

#include <cerrno>
#include <system_error>

#include "host/base/error.hpp"

namespace brdftab {

std::ifstream open_file(const std::filesystem::path& file) {
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) throw FileError("{}: is a folder", file.string());
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError("{}: cannot be opened: {}", file.string(), std::generic_category().message(errno));
  return in;
}

std::string read_beginning(const std::filesystem::path& file, std::size_t bytes) {
  std::ifstream in = open_file(file);
  std::string beginning(bytes, '\0');
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  if (in.bad()) throw FileError("{}: cannot be read", file.string());
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  return beginning;
}

std::string read_whole(const std::filesystem::path& file) {
  std::ifstream in = open_file(file);
  std::string bytes;
  in.seekg(0, std::ios::end);
  if (const auto size = in.tellg(); size > 0) bytes.resize(static_cast<std::size_t>(size));
  in.seekg(0);
  in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!in) throw FileError("{}: cannot be read", file.string());
  return bytes;
}

namespace {

// `target` stands for the file in messages.
void write(const std::filesystem::path& file, const std::filesystem::path& target, std::string_view bytes) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out)
    throw FileError("{}: cannot be written: {}", target.string(), std::generic_category().message(errno));
}

}  // namespace

void write_whole(const std::filesystem::path& file, std::string_view bytes) { write(file, file, bytes); }

void write_whole(PartialFile& file, std::string_view bytes) {
  write(file.path(), file.target(), bytes);
  file.commit();
}

}  // namespace brdftab

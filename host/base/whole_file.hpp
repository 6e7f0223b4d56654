// Files opened for reading, and files small enough to be read and written whole.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include "host/base/partial_file.hpp"

namespace brdftab {

/// Opens a file in binary mode. Throws FileError where it is a folder or cannot be opened, with the reason.
std::ifstream open_file(const std::filesystem::path& file);

/// The first bytes of a file, or all of them where it is shorter. Throws FileError.
std::string read_beginning(const std::filesystem::path& file, std::size_t bytes);

/// Throws FileError.
std::string read_whole(const std::filesystem::path& file);
void write_whole(const std::filesystem::path& file, std::string_view bytes);
/// Gives the file its name, too.
void write_whole(PartialFile& file, std::string_view bytes);

}  // namespace brdftab

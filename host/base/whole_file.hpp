// Files small enough to be read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/partial_file.hpp"

namespace brdftab {

/// Throws FileError.
std::string read_whole(const std::filesystem::path& file);
void write_whole(const std::filesystem::path& file, std::string_view bytes);
/// Gives the file its name, too.
void write_whole(PartialFile& file, std::string_view bytes);

}  // namespace brdftab

// Files small enough to be read and written whole.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace brdftab {

/// Throws FileError.
std::string read_whole(const std::filesystem::path& file);
void write_whole(const std::filesystem::path& file, std::string_view bytes);

}  // namespace brdftab

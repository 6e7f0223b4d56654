// Tables of this program, opened by what their files hold.
#pragma once

#include <filesystem>
#include <memory>

namespace brdftab {

class TableReader;

/// The file's first bytes tell its format; a folder holds the slices of an OpenEXR table. Throws FileError
/// where the file cannot be read or is damaged, and BadInput where it is no table of this program.
std::unique_ptr<TableReader> open_table(const std::filesystem::path& file);

/// Says whether a file is to be opened as a table: a folder, what is named as a table, or begins as one; "-"
/// is not.
bool is_table(const std::filesystem::path& file);

}  // namespace brdftab

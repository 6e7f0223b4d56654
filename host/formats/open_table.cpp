#include "host/formats/open_table.hpp"

#include <fmt/ranges.h>

#include <string_view>
#include <vector>

#include "host/base/error.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {

std::unique_ptr<TableReader> open_table(const std::filesystem::path& file) {
  const Formats formats = all_formats();
  const Format* format = recognised_format(formats, file);
  if (format && format->as_dense()) return format->as_dense()->open(file);
  if (format)
    throw BadInput("{}: is a simulator's file ({}), no table", file.string(), format->traits().name);
  if (std::filesystem::file_size(file) == 0) throw FileError("{}: is empty", file.string());
  std::vector<std::string_view> names;
  for (const auto& known : formats)
    if (known->as_dense()) names.push_back(known->traits().name);
  throw BadInput("{}: is no table: it is neither {}", file.string(), fmt::join(names, " nor "));
}

bool is_table(const std::filesystem::path& file) {
  if (file == "-") return false;
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) return true;
  const Formats formats = all_formats();
  // What is named as a table and damaged is to be refused as a table.
  const Format* named = format_of_extension(formats, file.extension().string());
  if (named && named->as_dense()) return true;
  // A pipe can be read once only.
  if (!std::filesystem::is_regular_file(file, error)) return false;
  const Format* format = recognised_format(formats, file);
  return format && format->as_dense();
}

}  // namespace brdftab

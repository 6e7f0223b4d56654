// What the formats in JSON share.
#pragma once

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_model.hpp"

namespace brdftab {

/// Throws BadInput where a file would have more samples, of all bands together, than its readers can be
/// expected to hold.
void check_json_samples(std::string_view format, std::size_t samples);

/// Makes an identifier of version 8 of RFC 9562, 8-4-4-4-12 hexadecimal digits, which is the same for the
/// same text.
std::string uuid_of(std::string_view text);

/// Gives the file's time, as 2008-08-18T12:00:00Z: the history begins with it.
std::string timestamp(const ExportModel& source);

/// Writes a value as JSON; text that is not UTF-8 is mended.
std::string json_text(const nlohmann::ordered_json& value);

/// Gives what `read` makes of a file's content. Throws FileError where the file cannot be read, and BadInput
/// `FILE: ...` where it is not JSON or `read` misses something.
template <class Read>
auto read_json(const std::filesystem::path& file, const Read& read) {
  const std::string text = read_whole(file);
  try {
    return read(nlohmann::json::parse(text));
  } catch (const nlohmann::json::exception& fault) {
    throw BadInput("{}: {}", file.string(), fault.what());
  }
}

}  // namespace brdftab

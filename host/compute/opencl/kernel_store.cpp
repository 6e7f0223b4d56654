#include "host/compute/opencl/kernel_store.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

// All kernels of one program take 0.3 MB, and each further length of a work-group 0.02 MB for each kernel.
constexpr std::uintmax_t most_bytes = 32u << 20;

std::uint32_t checksum(const std::string& bytes) { return libdeflate_crc32(0, bytes.data(), bytes.size()); }

fs::path named_with(std::uint32_t checksum, const fs::path& file) {
  return file.parent_path() / fmt::format("{}.{:08x}", file.filename().string(), checksum);
}

// The checksum at the end of a name, and the path without it.
std::optional<std::pair<fs::path, std::uint32_t>> split_name(const fs::path& file) {
  const std::string digits = file.extension().string();
  std::uint32_t checksum = 0;
  if (digits.size() != 9) return std::nullopt;
  const auto [end, error] = std::from_chars(digits.data() + 1, digits.data() + digits.size(), checksum, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return std::pair{file.parent_path() / file.stem(), checksum};
}

// Whatever stands in the folder but sub-folders, the newest first.
std::vector<fs::directory_entry> entries(const fs::path& folder) {
  std::vector<std::pair<fs::file_time_type, fs::directory_entry>> found;
  std::error_code error;
  for (fs::recursive_directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code ignored;
    const auto status = it->symlink_status(ignored);
    if (status.type() == fs::file_type::directory && !split_name(it->path())) {
      // One that cannot be entered could be neither read nor mended.
      if ((status.permissions() & fs::perms::owner_all) != fs::perms::owner_all)
        fs::permissions(it->path(), fs::perms::owner_all, ignored);
      continue;
    }
    if (status.type() == fs::file_type::directory) it.disable_recursion_pending();
    found.emplace_back(fs::last_write_time(it->path(), ignored), *it);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<fs::directory_entry> sorted;
  for (auto& [time, entry] : found) sorted.push_back(std::move(entry));
  return sorted;
}

struct Content {
  std::string bytes;
  std::string fault;  // empty if the bytes are those that were kept
};

Content content(const fs::directory_entry& entry, std::uint32_t expected) {
  std::error_code error;
  if (entry.symlink_status(error).type() != fs::file_type::regular) return {{}, "is not a regular file"};
  if (entry.file_size(error) > most_bytes) return {{}, "is too long"};
  Content result;
  try {
    result.bytes = read_whole(entry.path());
    if (result.bytes.empty())
      result.fault = "is empty";
    else if (checksum(result.bytes) != expected)
      result.fault = "has another checksum than when it was written";
  } catch (const FileError&) {
    result.fault = "cannot be read";
  }
  return result;
}

// What a driver writes without renaming it into place, or has not yet renamed.
bool is_temporary(const fs::path& file) {
  const auto name = file.filename();
  return name == "build.log" || name == "last_accessed" || name.extension() == ".temp";
}

}  // namespace

KernelStore::KernelStore(fs::path folder) : folder_(std::move(folder)) {}

KernelStore::Damage KernelStore::restore(const fs::path& work) const {
  Damage damage;
  std::error_code ignored;
  const auto reject = [&](const fs::path& file, std::string_view fault) {
    if (damage.files++ == 0)
      damage.first = fmt::format("{} {}", file.lexically_relative(folder_).string(), fault);
    fs::remove_all(file, ignored);
  };
  if (fs::exists(fs::symlink_status(folder_, ignored)) &&
      !fs::is_directory(fs::symlink_status(folder_, ignored)))
    reject(folder_, "is not a folder");
  std::uintmax_t bytes = 0;
  for (const auto& entry : entries(folder_)) {
    const auto name = split_name(entry.path());
    if (!name) {
      reject(entry.path(), "has no checksum");
      continue;
    }
    const auto target = work / name->first.lexically_relative(folder_);
    const auto [kernel, fault] = content(entry, name->second);
    bytes += kernel.size();
    if (!fault.empty()) {
      // Another process may have removed it meanwhile.
      if (fs::exists(entry.symlink_status(ignored))) reject(entry.path(), fault);
    } else if (bytes > most_bytes || fs::exists(target, ignored)) {
      // Processes that ran at once have each compiled it: the newest serves.
      fs::remove(entry.path(), ignored);
    } else {
      fs::create_directories(target.parent_path(), ignored);
      write_whole(target, kernel);
    }
  }
  return damage;
}

void KernelStore::keep(const fs::path& work) const noexcept try {
  for (const auto& entry : entries(work)) {
    const auto place = entry.path().lexically_relative(work);
    if (!entry.is_regular_file() || !place.has_parent_path() || is_temporary(place)) continue;
    const auto bytes = read_whole(entry.path());
    const auto kept = folder_ / named_with(checksum(bytes), place);
    std::error_code error;
    if (bytes.empty() || fs::exists(fs::symlink_status(kept, error))) continue;
    fs::create_directories(kept.parent_path(), error);
    fs::rename(entry.path(), kept, error);
  }
} catch (const std::exception&) {
  // What is not kept is compiled again.
}

}  // namespace brdftab

#include "host/pocl_cache.hpp"

#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <system_error>
#include <vector>

#include "host/error.hpp"

namespace brdftab {
namespace {

// Far more than the kernels take, built for each precision and local size.
constexpr unsigned long long room_needed = 64ull << 20;

// Empty if PoCL can work in the folder, otherwise the cause.
std::string obstacle(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) return fmt::format("cannot be made: {}", error.message());
  std::string probe = (folder / "probe-XXXXXX").string();
  const int descriptor = mkstemp(probe.data());
  if (descriptor < 0) return fmt::format("cannot be written: {}", std::generic_category().message(errno));
  close(descriptor);
  unlink(probe.c_str());
  struct statvfs space {};
  if (statvfs(folder.c_str(), &space) == 0 && static_cast<unsigned long long>(space.f_bavail) * space.f_frsize < room_needed)
    return fmt::format("has less than {} MiB of free space", room_needed >> 20);
  return {};
}

// A folder in a place that everyone may write is ours only if we own it.
bool is_ours(const std::filesystem::path& folder) {
  mkdir(folder.c_str(), 0700);
  struct stat status {};
  return lstat(folder.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid();
}

}  // namespace

void choose_pocl_cache() {
  if (const char* chosen = std::getenv("POCL_CACHE_DIR"); chosen && *chosen) {
    if (const auto cause = obstacle(chosen); !cause.empty())
      throw Error(ExitStatus::device, "POCL_CACHE_DIR={}: {}; set it to a writable folder, or unset it", chosen, cause);
    return;
  }
  std::string causes;
  const auto take = [&](const std::filesystem::path& folder) {
    const auto cause = obstacle(folder);
    if (cause.empty())
      setenv("POCL_CACHE_DIR", folder.c_str(), 1);
    else
      causes += fmt::format("; {} {}", folder.string(), cause);
    return cause.empty();
  };
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache && take(std::filesystem::path(cache) / "pocl")) return;
  if (const char* home = std::getenv("HOME"); home && *home && take(std::filesystem::path(home) / ".cache" / "pocl")) return;
  std::vector<std::filesystem::path> shared;
  if (const char* temporary = std::getenv("TMPDIR"); temporary && *temporary) shared.emplace_back(temporary);
  shared.insert(shared.end(), {"/var/tmp", "/tmp"});
  for (const auto& place : shared) {
    const auto folder = place / fmt::format("brdftab-pocl-{}", geteuid());
    if (is_ours(folder) && take(folder)) return;
  }
  throw Error(ExitStatus::device, "no folder for PoCL's compiled kernels{}; set POCL_CACHE_DIR to a writable folder with space",
              causes);
}

}  // namespace brdftab

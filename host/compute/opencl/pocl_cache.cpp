#include "host/compute/opencl/pocl_cache.hpp"

#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include "host/base/error.hpp"
#include "host/base/run_folder.hpp"
#include "host/compute/opencl/kernel_store.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

// Far more than the kernels take, built for each precision and local size.
constexpr unsigned long long room_needed = 64ull << 20;

class PoclCache {
 public:
  explicit PoclCache(const fs::path& folder)
      : run_(folder), store_(folder / "kernels"), damage_(store_.restore(run_.path())) {}
  PoclCache(const PoclCache&) = delete;
  PoclCache& operator=(const PoclCache&) = delete;
  ~PoclCache() {
    if (run_.is_ours()) store_.keep(run_.path());
  }

  const fs::path& work() const { return run_.path(); }
  const KernelStore::Damage& damage() const { return damage_; }

 private:
  RunFolder run_;
  KernelStore store_;
  KernelStore::Damage damage_;
};

std::string damage_line;
fs::path chosen_folder;

// Empty if there is enough space, otherwise how little.
std::string shortage(const fs::path& folder) {
  struct statvfs space {};
  if (statvfs(folder.c_str(), &space) != 0 ||
      static_cast<unsigned long long>(space.f_bavail) * space.f_frsize >= room_needed)
    return {};
  return fmt::format("has less than {} MiB of free space", room_needed >> 20);
}

// Empty if PoCL can work in the folder, otherwise the cause.
std::string obstacle(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder.parent_path(), error);
  if (error) return fmt::format("cannot be made: {}", error.message());
  // A folder in a place that everyone may write is ours only if we own it.
  if (mkdir(folder.c_str(), 0700) != 0 && errno != EEXIST)
    return fmt::format("cannot be written: {}", std::generic_category().message(errno));
  struct stat status {};
  if (lstat(folder.c_str(), &status) != 0 || !S_ISDIR(status.st_mode) || status.st_uid != geteuid())
    return fmt::format("holds {}, which is not a folder of this user", folder.filename().string());
  return shortage(folder);
}

// The cache in a place, or none and the cause.
std::pair<std::unique_ptr<PoclCache>, std::string> cache_in(const fs::path& place) {
  const auto folder = fs::absolute(place) / fmt::format("brdftab-pocl-{}", geteuid());
  if (auto cause = obstacle(folder); !cause.empty()) return {nullptr, std::move(cause)};
  try {
    return {std::make_unique<PoclCache>(folder), std::string()};
  } catch (const std::system_error& error) {
    return {nullptr, fmt::format("cannot be written: {}", error.code().message())};
  } catch (const FileError& error) {
    return {nullptr, error.what()};
  }
}

std::vector<fs::path> places() {
  std::vector<fs::path> result;
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache) result.emplace_back(cache);
  if (const char* home = std::getenv("HOME"); home && *home) result.push_back(fs::path(home) / ".cache");
  if (const char* temporary = std::getenv("TMPDIR"); temporary && *temporary) result.emplace_back(temporary);
  result.insert(result.end(), {"/var/tmp", "/tmp"});
  return result;
}

std::unique_ptr<PoclCache> find_cache() {
  if (const char* chosen = std::getenv("POCL_CACHE_DIR"); chosen && *chosen) {
    auto [cache, cause] = cache_in(chosen);
    if (!cache)
      throw Error(Fault::device, "POCL_CACHE_DIR={}: {}; set it to a writable folder, or unset it", chosen,
                  cause);
    return std::move(cache);
  }
  std::string causes;
  for (const auto& place : places()) {
    auto [cache, cause] = cache_in(place);
    if (cache) return std::move(cache);
    causes += fmt::format("; {} {}", place.string(), cause);
  }
  throw Error(Fault::device,
              "no folder for PoCL's compiled kernels{}; set POCL_CACHE_DIR to a writable folder with space",
              causes);
}

std::unique_ptr<PoclCache> open_cache() {
  auto cache = find_cache();
  setenv("POCL_CACHE_DIR", cache->work().c_str(), 1);
  chosen_folder = cache->work().parent_path();
  if (const auto& [files, first] = cache->damage(); files > 0)
    damage_line = fmt::format("PoCL's cache {} was damaged ({}{}): what is missing is compiled anew",
                              cache->work().parent_path().string(), first,
                              files == 1 ? "" : fmt::format("; {} files in all", files));
  return cache;
}

}  // namespace

void choose_pocl_cache() { static const std::unique_ptr<PoclCache> cache = open_cache(); }

const std::string& damaged_pocl_cache() { return damage_line; }

std::string pocl_cache_folder() { return chosen_folder.string(); }

std::string pocl_cache_shortage() {
  const std::string cause = chosen_folder.empty() ? "" : shortage(chosen_folder);
  return cause.empty() ? "" : fmt::format("{} {}", chosen_folder.string(), cause);
}

}  // namespace brdftab

#include "host/base/run_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

constexpr const char* lock_name = "lock";
// A folder is named so once it is locked.
constexpr std::string_view locked_prefix = "run-";
constexpr std::string_view new_prefix = "new-";

bool lock(int descriptor) { return flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool is_abandoned(const fs::path& folder) {
  const std::string name = folder.filename().string();
  std::error_code error;
  const auto since = fs::last_write_time(folder, error);
  const bool old = !error && fs::file_time_type::clock::now() - since > std::chrono::hours(1);
  if (name.starts_with(new_prefix)) return old;
  if (!name.starts_with(locked_prefix)) return false;
  const int descriptor = open((folder / lock_name).c_str(), O_RDWR | O_CLOEXEC);
  if (descriptor < 0) return old && errno == ENOENT;
  const bool free = lock(descriptor);
  close(descriptor);
  return free;
}

void remove_abandoned(const fs::path& parent) {
  std::error_code error;
  std::vector<fs::path> abandoned;
  for (fs::directory_iterator it(parent, error), end; !error && it != end; it.increment(error))
    if (is_abandoned(it->path())) abandoned.push_back(it->path());
  for (const auto& folder : abandoned) fs::remove_all(folder, error);
}

}  // namespace

RunFolder::RunFolder(const fs::path& parent) : owner_(getpid()) {
  remove_abandoned(parent);
  std::string name = (parent / fmt::format("{}XXXXXX", new_prefix)).string();
  if (!mkdtemp(name.data())) throw std::system_error(errno, std::generic_category());
  path_ = name;
  lock_ = open((path_ / lock_name).c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600);
  // Where the file system knows no locks, nobody else can lock the folder and take it for abandoned.
  if (lock_ >= 0) lock(lock_);
  const auto locked = parent / fmt::format("{}{}", locked_prefix, name.substr(name.size() - 6));
  std::error_code error;
  if (lock_ >= 0) fs::rename(path_, locked, error);
  if (lock_ < 0 || error) {
    const auto cause = error ? error : std::error_code(errno, std::generic_category());
    fs::remove_all(path_, error);
    if (lock_ >= 0) close(lock_);
    throw std::system_error(cause);
  }
  path_ = locked;
}

RunFolder::~RunFolder() {
  std::error_code error;
  if (is_ours()) fs::remove_all(path_, error);
  close(lock_);
}

bool RunFolder::is_ours() const { return getpid() == owner_; }

}  // namespace brdftab

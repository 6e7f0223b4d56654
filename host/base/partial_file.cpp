#include "host/base/partial_file.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <cerrno>
#include <random>
#include <system_error>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

std::string system_message(int code) { return std::generic_category().message(code); }

// Creates an empty file under a name that nobody has. mkstemp would make it private, and nothing but opening
// a file tells what the umask leaves of its mode without a moment in which other threads see another umask.
std::filesystem::path created_in(const std::filesystem::path& folder, const std::filesystem::path& target) {
  std::random_device random;
  for (;;) {
    const auto name = folder / fmt::format(".{}.{:08x}", target.filename().string(), random());
    const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor >= 0) {
      close(descriptor);
      return name;
    }
    if (errno != EEXIST) throw FileError("{}: cannot be written: {}", target.string(), system_message(errno));
  }
}

[[noreturn]] void refuse_overwrite(const std::filesystem::path& target) {
  throw FileError("{}: exists; `force` overwrites it", target.string());
}

}  // namespace

PartialFile::PartialFile(std::filesystem::path target, bool force)
    : target_(std::move(target)), force_(force) {
  std::error_code error;
  // A link is followed, so that it stays.
  if (std::filesystem::is_symlink(target_, error))
    target_ = std::filesystem::weakly_canonical(target_, error);
  const auto folder = target_.has_parent_path() ? target_.parent_path() : std::filesystem::path(".");
  if (std::filesystem::is_directory(target_, error)) throw FileError("{}: is a folder", target_.string());
  if (!std::filesystem::is_directory(folder, error))
    throw FileError("{}: the folder {} does not exist", target_.string(), folder.string());
  const auto status = std::filesystem::symlink_status(target_, error);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    throw FileError("{}: is not a regular file", target_.string());
  if (!force && std::filesystem::exists(status)) refuse_overwrite(target_);
  partial_ = created_in(folder, target_);
}

PartialFile::~PartialFile() {
  std::error_code error;
  if (!partial_.empty()) std::filesystem::remove_all(partial_, error);
}

void PartialFile::require_space(unsigned long long bytes) const {
  struct statvfs space {};
  if (statvfs(partial_.c_str(), &space) != 0) return;
  const auto available = static_cast<unsigned long long>(space.f_bavail) * space.f_frsize;
  if (bytes > available)
    throw FileError("{}: needs {:.3g} GB, and its folder has {:.3g} GB of free space", target_.string(),
                    static_cast<double>(bytes) / 1e9, static_cast<double>(available) / 1e9);
}

void PartialFile::commit() {
  const unsigned flags = force_ ? 0 : RENAME_NOREPLACE;
  int status = renameat2(AT_FDCWD, partial_.c_str(), AT_FDCWD, target_.c_str(), flags);
  // Some file systems know no flags.
  if (status != 0 && flags != 0 && errno == EINVAL) {
    if (std::filesystem::exists(target_)) refuse_overwrite(target_);
    status = rename(partial_.c_str(), target_.c_str());
  }
  if (status != 0) {
    if (errno == EEXIST) refuse_overwrite(target_);
    throw FileError("{}: cannot be named so: {}", target_.string(), system_message(errno));
  }
  partial_.clear();
}

}  // namespace brdftab

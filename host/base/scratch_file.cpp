#include "host/base/scratch_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

[[noreturn]] void fail(const char* what, int code) {
  throw FileError("{}: {}", what, std::generic_category().message(code));
}

}  // namespace

ScratchFile::ScratchFile(const std::filesystem::path& output, std::size_t bytes) {
  std::string name = output.string() + ".XXXXXX";
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("scratch file", errno);
  unlink(name.c_str());
  if (const int code = posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes))) {
    close(descriptor_);
    fail("scratch file of the samples", code);
  }
}

ScratchFile::~ScratchFile() { close(descriptor_); }

void ScratchFile::write(std::size_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("scratch file of the samples", written < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::size_t>(written);
  }
}

void ScratchFile::read(std::size_t offset, std::span<std::byte> bytes) const {
  while (!bytes.empty()) {
    const ssize_t got = pread(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) fail("scratch file of the samples", got < 0 ? errno : EIO);
    bytes = bytes.subspan(static_cast<std::size_t>(got));
    offset += static_cast<std::size_t>(got);
  }
}

}  // namespace brdftab

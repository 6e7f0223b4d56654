#include "host/scratch_file.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "host/error.hpp"

namespace brdftab {
namespace {

[[noreturn]] void fail(const char* what, int code) { throw FileError("{}: {}", what, std::generic_category().message(code)); }

}  // namespace

ScratchFile::ScratchFile(const std::filesystem::path& output, std::size_t bytes) : bytes_(bytes) {
  std::string name = output.string() + ".XXXXXX";
  descriptor_ = mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail("scratch file", errno);
  unlink(name.c_str());
  if (const int code = posix_fallocate(descriptor_, 0, static_cast<off_t>(bytes))) {
    close(descriptor_);
    fail("scratch file of the samples", code);
  }
}

ScratchFile::~ScratchFile() {
  if (mapped_) munmap(mapped_, bytes_);
  close(descriptor_);
}

void ScratchFile::write(std::size_t offset, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) fail("scratch file of the samples", written < 0 ? errno : ENOSPC);
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    offset += static_cast<std::size_t>(written);
  }
}

std::span<const std::byte> ScratchFile::map() {
  if (!mapped_) {
    void* at = mmap(nullptr, bytes_, PROT_READ, MAP_SHARED, descriptor_, 0);
    if (at == MAP_FAILED) fail("scratch file of the samples", errno);
    mapped_ = at;
  }
  return {static_cast<const std::byte*>(mapped_), bytes_};
}

}  // namespace brdftab

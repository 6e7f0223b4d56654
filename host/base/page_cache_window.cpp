#include "host/base/page_cache_window.hpp"

#include <fcntl.h>
#include <unistd.h>

namespace brdftab {
namespace {

constexpr std::size_t most_pieces = 4;

// Linux makes writers wait once a fifth of the memory that is free is dirty; a little more does no harm.
std::uint64_t comfortable_bytes() {
  return static_cast<std::uint64_t>(sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) / 4;
}

}  // namespace

PageCacheWindow::PageCacheWindow(const std::filesystem::path& file, std::uint64_t file_bytes) {
  if (file_bytes > comfortable_bytes()) descriptor_ = open(file.c_str(), O_RDONLY | O_CLOEXEC);
}

PageCacheWindow::~PageCacheWindow() {
  if (descriptor_ >= 0) close(descriptor_);
}

// Hints: where a file system does not take them, the writes are as they would have been.
void PageCacheWindow::written(std::uint64_t offset, std::uint64_t bytes) {
  if (descriptor_ < 0) return;
  sync_file_range(descriptor_, static_cast<off64_t>(offset), static_cast<off64_t>(bytes),
                  SYNC_FILE_RANGE_WRITE);
  pieces_.push_back({offset, bytes});
  if (pieces_.size() <= most_pieces) return;
  const Piece oldest = pieces_.front();
  pieces_.pop_front();
  sync_file_range(descriptor_, static_cast<off64_t>(oldest.offset), static_cast<off64_t>(oldest.bytes),
                  SYNC_FILE_RANGE_WAIT_BEFORE | SYNC_FILE_RANGE_WRITE | SYNC_FILE_RANGE_WAIT_AFTER);
  posix_fadvise(descriptor_, static_cast<off_t>(oldest.offset), static_cast<off_t>(oldest.bytes),
                POSIX_FADV_DONTNEED);
}

}  // namespace brdftab

// Keeps a long run of writes from filling the page cache: past what memory holds, a kernel that is left to
// itself alternates between copying and waiting for the disk.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>

namespace brdftab {

class PageCacheWindow {
 public:
  /// For a file of `file_bytes` that others write; it does nothing where memory holds that easily.
  PageCacheWindow(const std::filesystem::path& file, std::uint64_t file_bytes);
  PageCacheWindow(const PageCacheWindow&) = delete;
  PageCacheWindow& operator=(const PageCacheWindow&) = delete;
  ~PageCacheWindow();

  /// Says that a piece has been written: its way to the disk begins, that of the piece four before is
  /// awaited.
  void written(std::uint64_t offset, std::uint64_t bytes);

 private:
  struct Piece {
    std::uint64_t offset;
    std::uint64_t bytes;
  };

  int descriptor_ = -1;
  std::deque<Piece> pieces_;
};

}  // namespace brdftab

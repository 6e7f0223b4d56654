// A nameless file beside an output, for data that must wait: it goes with the process, whatever happens.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>

namespace brdftab {

class ScratchFile {
 public:
  /// In the folder of `output`, with its bytes allocated. Throws FileError where there is no room.
  ScratchFile(const std::filesystem::path& output, std::size_t bytes);
  ScratchFile(const ScratchFile&) = delete;
  ScratchFile& operator=(const ScratchFile&) = delete;
  ~ScratchFile();

  void write(std::size_t offset, std::span<const std::byte> bytes);

  void read(std::size_t offset, std::span<std::byte> bytes) const;

 private:
  int descriptor_ = -1;
};

}  // namespace brdftab

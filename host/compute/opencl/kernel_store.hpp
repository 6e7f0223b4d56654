// Compiled kernels kept between runs. A driver that loads a damaged one is killed by a signal, or computes
// something else in silence; so each file's name ends in the CRC-32 of its bytes, and only files that match
// reach the driver.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

namespace brdftab {

/// Any number of processes may use one store at once: files appear in it by renaming, whole, and are never
/// changed.
class KernelStore {
 public:
  struct Damage {
    std::size_t files = 0;
    std::string first;  // the first file and what is wrong with it; empty if none is
  };

  explicit KernelStore(std::filesystem::path folder);

  /// Copies the sound files into `work`, the newest first and no more than the store's limit in all; removes
  /// the others. Throws FileError where `work` cannot be written.
  Damage restore(const std::filesystem::path& work) const;

  /// Moves what the driver has added to the sub-folders of `work` into the store, as far as that is possible.
  /// `work` lies on the store's file system and is given up afterwards. Files directly in `work` are the
  /// driver's temporary ones.
  void keep(const std::filesystem::path& work) const noexcept;

 private:
  std::filesystem::path folder_;
};

}  // namespace brdftab

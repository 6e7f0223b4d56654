// An output appears under its name only when it is complete.
#pragma once

#include <filesystem>

namespace brdftab {

/// The file is written beside its place and renamed by `commit`; it is removed if that does not happen.
class PartialFile {
 public:
  /// Throws FileError if `target` exists and `force` is not set, if its folder is missing or not writable, or
  /// if `target` is a folder.
  PartialFile(std::filesystem::path target, bool force);
  PartialFile(const PartialFile&) = delete;
  PartialFile& operator=(const PartialFile&) = delete;
  ~PartialFile();

  /// The name that it will have.
  const std::filesystem::path& target() const { return target_; }
  /// A writer may put a folder in the place of the file.
  const std::filesystem::path& path() const { return partial_; }

  /// Throws FileError unless the folder has room for `bytes`.
  void require_space(unsigned long long bytes) const;

  /// Gives the file its name; without `force`, never over a file that has appeared meanwhile.
  void commit();

 private:
  std::filesystem::path target_;
  std::filesystem::path partial_;
  bool force_;
};

}  // namespace brdftab

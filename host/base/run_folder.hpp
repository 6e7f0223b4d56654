// A folder of one run of the program.
#pragma once

#include <sys/types.h>

#include <filesystem>

namespace brdftab {

/// Nothing else writes into it, and it is removed with the object. Those of runs that were killed are removed
/// by the next run: a lock tells them from those in use.
class RunFolder {
 public:
  /// In `parent`, which exists. Throws std::system_error.
  explicit RunFolder(const std::filesystem::path& parent);
  ~RunFolder();
  RunFolder(const RunFolder&) = delete;
  RunFolder& operator=(const RunFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  /// False in a child process, whose end must not take the folder from its parent.
  bool is_ours() const;

 private:
  std::filesystem::path path_;
  int lock_;
  pid_t owner_;
};

}  // namespace brdftab

// How a file stores one variable.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace brdftab {

struct StorageInfo {
  std::string layout;  // contiguous, chunked, virtual or other
  std::vector<std::size_t> chunk;
  std::vector<std::string> filters;
  std::string view_of;    // the variable that a virtual one shows
  std::size_t bytes = 0;  // in the file
  double ratio = 0;       // of the samples' bytes to those in the file; 0 where there are none

  /// In words.
  std::string text() const;
};

}  // namespace brdftab

// The stream under an OpenEXR file that is written: OpenEXR writes its table of offsets in a destructor,
// where it swallows errors; this remembers them.
#pragma once

#include <OpenEXR/ImfIO.h>

#include <cstdio>
#include <filesystem>

namespace brdftab {

class ExrStream : public Imf::OStream {
 public:
  /// Writes over an existing file, or a new one. Throws FileError.
  explicit ExrStream(const std::filesystem::path& path);
  ~ExrStream() override;

  void write(const char bytes[], int count) override;
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override;

  /// To be called after the OpenEXR file is gone. Throws FileError if anything was not written.
  void close();

 private:
  void fail();

  std::FILE* file_;
  uint64_t position_ = 0;
  int failure_ = 0;  // errno
};

}  // namespace brdftab

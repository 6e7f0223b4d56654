#include "host/formats/exr/exr_stream.hpp"

#include <cerrno>
#include <system_error>
#include <utility>

#include "host/base/error.hpp"

namespace brdftab {

ExrStream::ExrStream(const std::filesystem::path& path)
    : Imf::OStream(path.c_str()), file_(std::fopen(path.c_str(), "wbe")) {
  if (!file_) throw FileError("{}", std::generic_category().message(errno));
}

ExrStream::~ExrStream() {
  if (file_) std::fclose(file_);
}

void ExrStream::write(const char bytes[], int count) {
  if (failure_ ||
      std::fwrite(bytes, 1, static_cast<std::size_t>(count), file_) != static_cast<std::size_t>(count))
    fail();
  position_ += static_cast<uint64_t>(count);
}

void ExrStream::seekp(uint64_t position) {
  if (failure_ || fseeko(file_, static_cast<off_t>(position), SEEK_SET) != 0) fail();
  position_ = position;
}

void ExrStream::fail() {
  if (!failure_) failure_ = errno ? errno : EIO;
  throw FileError("{}", std::generic_category().message(failure_));
}

void ExrStream::close() {
  if (std::fclose(std::exchange(file_, nullptr)) != 0 && !failure_) failure_ = errno;
  if (failure_) throw FileError("{}", std::generic_category().message(failure_));
}

}  // namespace brdftab

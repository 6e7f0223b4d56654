// Exit statuses, and the one exception that carries one.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace brdftab {

enum class ExitStatus { done = 0, check_failed = 1, bad_input = 2, device = 3, file = 4, interrupted = 130 };

/// Thrown where a fault happens, caught once in main. The message is one line, but for a build log.
class Error : public std::runtime_error {
 public:
  Error(ExitStatus status, const std::string& message) : std::runtime_error(message), status_(status) {}

  template <class... Args>
  Error(ExitStatus status, fmt::format_string<Args...> format, Args&&... args)
      : Error(status, fmt::format(format, std::forward<Args>(args)...)) {}

  ExitStatus status() const { return status_; }

 private:
  ExitStatus status_;
};

/// Input that the user can mend: exit status 2.
class BadInput : public Error {
 public:
  template <class... Args>
  explicit BadInput(fmt::format_string<Args...> format, Args&&... args)
      : Error(ExitStatus::bad_input, format, std::forward<Args>(args)...) {}
};

/// A file that cannot be read or written: exit status 4.
class FileError : public Error {
 public:
  template <class... Args>
  explicit FileError(fmt::format_string<Args...> format, Args&&... args)
      : Error(ExitStatus::file, format, std::forward<Args>(args)...) {}
};

}  // namespace brdftab

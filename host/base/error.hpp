// What can go wrong, and the exceptions that say so.
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

namespace brdftab {

/// The kind of a fault. Whoever calls the library turns it into an exit status or an exception of its own.
enum class Fault {
  input,    // something that was given is not allowed
  device,   // an OpenCL device or its driver
  file,     // a file cannot be read or written
  check,    // a result is not what it has to be
  stopped,  // the caller asked for the end
};

/// The message is one line, except that a build log follows the failure of a kernel's build.
///
/// Messages name a setting in backquotes, by the name that it has in the library: `keep_bits`. Each user of
/// the library spells it as its own users know it: --keep-bits.
class Error : public std::runtime_error {
 public:
  Error(Fault fault, const std::string& message) : std::runtime_error(message), fault_(fault) {}

  template <class... Args>
  Error(Fault fault, fmt::format_string<Args...> format, Args&&... args)
      : Error(fault, fmt::format(format, std::forward<Args>(args)...)) {}

  Fault fault() const { return fault_; }

 private:
  Fault fault_;
};

/// A setting or a key, and the value that was given for it, as text.
struct GivenValue {
  std::string field;
  std::string value;
};

/// Something that was given and is not allowed.
class BadInput : public Error {
 public:
  template <class... Args>
  explicit BadInput(fmt::format_string<Args...> format, Args&&... args)
      : Error(Fault::input, format, std::forward<Args>(args)...) {}

  /// The message is "`FIELD` VALUE: ALLOWED".
  template <class... Args>
  explicit BadInput(GivenValue given, fmt::format_string<Args...> allowed, Args&&... args)
      : BadInput(std::string(), std::move(given), fmt::format(allowed, std::forward<Args>(args)...)) {}

  /// The message is "PLACE: FIELD = VALUE: ALLOWED": a value in a file.
  static BadInput at(const std::string& place, GivenValue given, std::string allowed) {
    const std::string message = fmt::format("{}: {} = {}: {}", place, given.field, given.value, allowed);
    return BadInput(message, std::move(given), std::move(allowed));
  }

  /// What was refused, where one value was; otherwise empty.
  const std::string& field() const { return given_.field; }
  const std::string& value() const { return given_.value; }
  /// What would have been allowed there.
  const std::string& allowed() const { return allowed_; }

 private:
  BadInput(const std::string& message, GivenValue given, std::string allowed)
      : Error(Fault::input,
              message.empty() ? fmt::format("`{}` {}: {}", given.field, given.value, allowed) : message),
        given_(std::move(given)),
        allowed_(std::move(allowed)) {}

  GivenValue given_;
  std::string allowed_;
};

/// A file that cannot be read or written.
class FileError : public Error {
 public:
  template <class... Args>
  explicit FileError(fmt::format_string<Args...> format, Args&&... args)
      : Error(Fault::file, format, std::forward<Args>(args)...) {}
};

}  // namespace brdftab

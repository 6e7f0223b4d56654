// How a caller follows long work, and how it ends it.
#pragma once

#include <functional>
#include <stop_token>
#include <string>
#include <string_view>

#include "host/base/error.hpp"

namespace brdftab {

/// How far a piece of work has come.
struct Progress {
  std::string what;
  std::size_t done;
  std::size_t total;
  std::size_t unit_bytes;  // of data that one unit of `done` stands for
};

/// What is said where the caller has asked for the end.
inline constexpr const char* stopped_message = "interrupted: nothing was written under the final name";

/// The library prints nothing: what it has to say goes to these functions, where they are set. Only one
/// thread at a time calls them.
struct Watch {
  std::function<void(const Progress&)> progress;
  std::function<void(std::string_view)> note;  // a line of text for the user
  std::stop_token stop;

  /// Throws Error (Fault::stopped) where the caller has asked for the end.
  void stop_if_asked() const {
    if (stop.stop_requested()) throw Error(Fault::stopped, stopped_message);
  }
};

}  // namespace brdftab

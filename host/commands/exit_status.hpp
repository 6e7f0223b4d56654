// What the program tells the shell.
#pragma once

#include "host/base/error.hpp"

namespace brdftab {

enum class ExitStatus { done = 0, check_failed = 1, bad_input = 2, device = 3, file = 4, interrupted = 130 };

constexpr ExitStatus exit_status(Fault fault) {
  switch (fault) {
    case Fault::check:
      return ExitStatus::check_failed;
    case Fault::input:
      return ExitStatus::bad_input;
    case Fault::device:
      return ExitStatus::device;
    case Fault::file:
      return ExitStatus::file;
    case Fault::stopped:
      return ExitStatus::interrupted;
  }
  return ExitStatus::check_failed;
}

}  // namespace brdftab

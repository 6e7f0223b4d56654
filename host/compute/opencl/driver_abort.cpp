#include "host/compute/opencl/driver_abort.hpp"

#include <signal.h>
#include <unistd.h>

#include <string>

#include "host/base/error.hpp"
#include "host/compute/opencl/pocl_cache.hpp"

namespace brdftab {
namespace {

// A handler cannot compose it.
const char* line = nullptr;
std::size_t line_length = 0;

extern "C" void on_abort(int) {
  [[maybe_unused]] const auto written = write(STDERR_FILENO, line, line_length);
  _exit(3);
}

}  // namespace

void catch_driver_abort() {
  // Never destroyed: an abort may come while the process ends.
  static const auto* const text = new std::string(
      fmt::format("brdftab: aborted, with the cause above. PoCL aborts where it cannot compile a kernel: it "
                  "takes the linker ld in PATH (Debian: binutils), and free space in {}\n",
                  pocl_cache_folder()));
  line = text->data();
  line_length = text->size();
  struct sigaction action {};
  action.sa_handler = on_abort;
  sigaction(SIGABRT, &action, nullptr);
}

}  // namespace brdftab

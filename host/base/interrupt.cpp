#include "host/base/interrupt.hpp"

#include <csignal>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

volatile std::sig_atomic_t signalled = 0;

extern "C" void on_signal(int) { signalled = 1; }

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGHUP, &action, nullptr);
}

bool interrupted() { return signalled != 0; }

void stop_if_interrupted() {
  if (interrupted()) throw Error(ExitStatus::interrupted, "interrupted: nothing was written under the final name");
}

}  // namespace brdftab

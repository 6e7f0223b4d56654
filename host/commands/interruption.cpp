#include "host/commands/interruption.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <system_error>
#include <thread>

namespace brdftab {
namespace {

volatile std::sig_atomic_t seen = 0;
int wake[2];  // a pipe: a handler may write to it, but may not ask a stop_source

extern "C" void on_signal(int) {
  seen = 1;
  const int error = errno;
  [[maybe_unused]] const auto written = write(wake[1], "", 1);
  errno = error;
}

}  // namespace

std::stop_token stop_on_signals() {
  if (pipe2(wake, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "pipe");
  std::stop_source source;
  // The thread waits for as long as the process lives.
  std::thread([source]() mutable {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    char byte;
    while (read(wake[0], &byte, 1) < 0 && errno == EINTR) {
    }
    source.request_stop();
  }).detach();
  struct sigaction action {};
  action.sa_handler = on_signal;
  action.sa_flags = static_cast<int>(SA_RESETHAND);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
  return source.get_token();
}

bool signalled() { return seen != 0; }

}  // namespace brdftab

#include "host/commands/progress_bar.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace brdftab {
namespace {

constexpr std::chrono::duration<double> terminal_interval{0.1};
constexpr std::chrono::duration<double> line_interval{10};
constexpr std::chrono::duration<double> silence{1};
constexpr std::size_t bar_cells = 24;

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(seconds + 0.5);
  return whole >= 3600 ? fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60)
                       : fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

ProgressBar::ProgressBar() : terminal_(isatty(STDERR_FILENO) == 1) {}

void ProgressBar::clear() {
  if (drawn_ && terminal_) fmt::print(stderr, "\r\x1b[K");
  drawn_ = false;
}

std::string ProgressBar::line(const Progress& progress, double seconds) const {
  const double share =
      progress.total == 0 ? 1 : static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double rate = static_cast<double>(progress.done) / seconds;
  const auto full = static_cast<std::size_t>(share * bar_cells);
  const std::string bar =
      terminal_ ? fmt::format("[{}{}] ", std::string(full, '#'), std::string(bar_cells - full, '.')) : "";
  return fmt::format("{} {}{:3.0f} %  {:.1f} M samples/s, {:.0f} MB/s, {} left", progress.what, bar,
                     100 * share, rate / 1e6, rate * static_cast<double>(progress.unit_bytes) / 1e6,
                     clock_text(share > 0 ? seconds * (1 - share) / share : 0));
}

void ProgressBar::report(const Progress& progress) {
  const auto now = Clock::now();
  if (progress.done == 0) start_ = last_ = now;
  if (progress.done == progress.total) return clear();
  if (now - start_ < silence || now - last_ < (terminal_ ? terminal_interval : line_interval)) return;
  last_ = now;
  const std::string text = line(progress, std::chrono::duration<double>(now - start_).count());
  if (terminal_)
    fmt::print(stderr, "\r\x1b[K{}", text);
  else
    fmt::print(stderr, "{}\n", text);
  std::fflush(stderr);
  drawn_ = true;
}

}  // namespace brdftab

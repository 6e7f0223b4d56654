// SIGINT, SIGTERM and SIGHUP as a question that long work asks.
#pragma once

namespace brdftab {

/// From here on, the first such signal sets a flag; a second one ends the process at once.
void catch_interrupts();

bool interrupted();

/// Throws Error (exit status 130) after a signal.
void stop_if_interrupted();

}  // namespace brdftab

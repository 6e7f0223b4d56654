// SIGINT, SIGTERM and SIGHUP as the stop token that the library asks.
#pragma once

#include <stop_token>

namespace brdftab {

/// From the first call on, the first such signal asks for a stop; a second one ends the process at once. The
/// program calls it once, before it starts threads.
std::stop_token stop_on_signals();

/// Whether such a signal has come: a read that it cut short has failed for no other reason.
bool signalled();

}  // namespace brdftab

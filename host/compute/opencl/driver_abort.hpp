// Where an OpenCL driver ends the process.
#pragma once

namespace brdftab {

/// PoCL aborts where it cannot compile or link a kernel at its first launch. From now on an abort ends the
/// program with exit status 3 and a line on standard error that says what to look at. To be called after the
/// drivers have started: they set handlers of their own.
void catch_driver_abort();

}  // namespace brdftab

#define BRDFTAB_WORKING_DOUBLE 1
#define BRDFTAB_REAL double
#define BRDFTAB_ENGINE Double
#include "tests/kernels_on_host.inc"

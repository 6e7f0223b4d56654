#define BRDFTAB_WORKING_DOUBLE 0
#define BRDFTAB_REAL float
#define BRDFTAB_ENGINE Float
#include "tests/kernels_on_host.inc"

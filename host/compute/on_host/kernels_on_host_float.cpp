#define BRDFTAB_WORKING_DOUBLE 0
#define BRDFTAB_REAL float
#include "host/compute/on_host/kernels_on_host.inc"

#define BRDFTAB_WORKING_DOUBLE 1
#define BRDFTAB_REAL double
#include "host/compute/on_host/kernels_on_host.inc"

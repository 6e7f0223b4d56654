// The whole program, one build for each working precision and table precision.
#include "evaluate.cl"
#include "tabulate.cl"
#include "mantissa.cl"

// Two programs from one source, one build for each precision: lists of directions, BRDFTAB_WIDTH at a time, and
// what is computed one angle or one node at a time.
#include "model.h"
#if BRDFTAB_DIRECTIONS
#include "directions.cl"
#else
#include "integrals.cl"
#include "tabulate.cl"
#include "mantissa.cl"
#include "store.cl"
#endif

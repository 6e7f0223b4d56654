// Three programs from one source, one build for each precision: lists of directions and gradients for fits,
// both BRDFTAB_WIDTH at a time, and what is computed one angle or one node at a time.
#include "model.h"
#include "peak_path.h"
#include "quadrature.h"
#if BRDFTAB_DIRECTIONS
#include "directions.cl"
#elif BRDFTAB_GRADIENTS
#include "gradients.cl"
#else
#include "integrals.cl"
#include "tabulate.cl"
#include "mantissa.cl"
#include "store.cl"
#endif

// Adaptive quadrature of a positive function over [0, 1]: a march of 15-point
// Gauss-Kronrod panels that shrink where the function is steep and grow where
// it is smooth. A caller evaluates the nodes; there are no function pointers here.
#pragma once
#include "dialect.h"

#define PANEL_NODES 15
// Past these a panel is accepted as it is, and its error tells: no integrand may hold a device for long.
#define MOST_PANELS 1000

// One more than the rule has, of no weight, to fill a vector.
CONSTANT scalar panel_node[PANEL_NODES + 1] = {
    SCALAR(0.0042723144395936803966), SCALAR(0.025446043828620737737),
    SCALAR(0.067567788320115451661),  SCALAR(0.12923440720030278007),
    SCALAR(0.20695638226615443486),   SCALAR(0.29707742431130141655),
    SCALAR(0.39610752249605076620),   SCALAR(0.5),
    SCALAR(0.60389247750394923380),   SCALAR(0.70292257568869858345),
    SCALAR(0.79304361773384556514),   SCALAR(0.87076559279969721993),
    SCALAR(0.93243221167988454834),   SCALAR(0.97455395617137926226),
    SCALAR(0.99572768556040631960),   SCALAR(0.5)};

CONSTANT scalar kronrod_weight[PANEL_NODES + 1] = {
    SCALAR(0.011467661005264612482), SCALAR(0.031546046314989276645),
    SCALAR(0.052395005161125091920), SCALAR(0.070326629857762959373),
    SCALAR(0.084502363319633963291), SCALAR(0.095175289032392704957),
    SCALAR(0.10221647003764944621),  SCALAR(0.10474107054236391400),
    SCALAR(0.10221647003764944621),  SCALAR(0.095175289032392704957),
    SCALAR(0.084502363319633963291), SCALAR(0.070326629857762959373),
    SCALAR(0.052395005161125091920), SCALAR(0.031546046314989276645),
    SCALAR(0.011467661005264612482), SCALAR(0.0)};

CONSTANT scalar gauss_weight[PANEL_NODES + 1] = {
    SCALAR(0.0), SCALAR(0.064742483084434846635), SCALAR(0.0), SCALAR(0.13985269574463833395),
    SCALAR(0.0), SCALAR(0.19091502525255947248),  SCALAR(0.0), SCALAR(0.20897959183673469388),
    SCALAR(0.0), SCALAR(0.19091502525255947248),  SCALAR(0.0), SCALAR(0.13985269574463833395),
    SCALAR(0.0), SCALAR(0.064742483084434846635), SCALAR(0.0), SCALAR(0.0)};

typedef struct {
  scalar position;
  scalar step;
  scalar integral;
  scalar error;  // absolute, estimated
  int panels;
} March;

FN March march_begin(scalar first_step) {
  March march;
  march.position = SCALAR(0.0);
  march.step = first_step;
  march.integral = SCALAR(0.0);
  march.error = SCALAR(0.0);
  march.panels = 0;
  return march;
}

FN int march_unfinished(March march) { return march.position < SCALAR(1.0); }

// Takes a panel's two estimates (over a unit interval) and accepts it or shortens the
// step: its error may be `tolerance`, relative, or `negligible`, absolute. The error follows QUADPACK: (200
// |K - G|/K)^1.5 K, the Kronrod rule's own error being far below its difference from the Gauss rule; but no
// less than a hundredth of it, for integrands that are not smooth.
FN March march_advance(March march, scalar kronrod, scalar gauss, scalar largest_step, scalar tolerance,
                       scalar negligible) {
  const scalar value = kronrod * march.step;
  const scalar difference = fabs(kronrod - gauss) * march.step;
  scalar error = SCALAR(0.0);
  if (difference > SCALAR(0.0)) {
    const scalar ratio = SCALAR(200.0) * difference / value;
    error = ratio < SCALAR(1.0) ? fmax(value * ratio * sqrt(ratio), SCALAR(0.01) * difference)
                                : fmax(difference, value);
  }
  march.panels += 1;
  if (!isfinite(value)) {
    march.integral = value;
    march.position = SCALAR(1.0);
  } else if (error <= fmax(tolerance * (value + march.integral), negligible) ||
             march.step <= SMALLEST_PANEL || march.panels > MOST_PANELS) {
    march.integral += value;
    march.error += error;
    march.position += march.step;
    march.step = fmin(march.step * SCALAR(2.0), largest_step);
    // The remainder is one panel when it is not much longer than the step; no sliver is left.
    const scalar left = SCALAR(1.0) - march.position;
    if (left < march.step * SCALAR(1.5)) march.step = left;
    if (left <= REAL_EPSILON * SCALAR(4.0)) march.position = SCALAR(1.0);
  } else {
    march.step *= SCALAR(0.5);
  }
  return march;
}

// Adaptive quadrature of a positive function over [0, 1]: a march of 15-point
// Gauss-Kronrod panels that shrink where the function is steep and grow where
// it is smooth. A caller evaluates the nodes; there are no function pointers here.
#pragma once
#include "dialect.h"

#define PANEL_NODES 15
// Past these a panel is accepted as it is, and its error tells: no integrand may hold a device for long.
#define MOST_PANELS 1000

// One more than the rule has, to fill a vector.
CONSTANT real panel_node[PANEL_NODES + 1] = {
    REAL(0.0042723144395936803966), REAL(0.025446043828620737737), REAL(0.067567788320115451661),
    REAL(0.12923440720030278007),   REAL(0.20695638226615443486),  REAL(0.29707742431130141655),
    REAL(0.39610752249605076620),   REAL(0.5),                     REAL(0.60389247750394923380),
    REAL(0.70292257568869858345),   REAL(0.79304361773384556514),  REAL(0.87076559279969721993),
    REAL(0.93243221167988454834),   REAL(0.97455395617137926226),  REAL(0.99572768556040631960), REAL(0.5)};

CONSTANT real kronrod_weight[PANEL_NODES] = {
    REAL(0.011467661005264612482), REAL(0.031546046314989276645), REAL(0.052395005161125091920),
    REAL(0.070326629857762959373), REAL(0.084502363319633963291), REAL(0.095175289032392704957),
    REAL(0.10221647003764944621),  REAL(0.10474107054236391400),  REAL(0.10221647003764944621),
    REAL(0.095175289032392704957), REAL(0.084502363319633963291), REAL(0.070326629857762959373),
    REAL(0.052395005161125091920), REAL(0.031546046314989276645), REAL(0.011467661005264612482)};

CONSTANT real gauss_weight[PANEL_NODES] = {
    REAL(0.0), REAL(0.064742483084434846635), REAL(0.0), REAL(0.13985269574463833395),
    REAL(0.0), REAL(0.19091502525255947248),  REAL(0.0), REAL(0.20897959183673469388),
    REAL(0.0), REAL(0.19091502525255947248),  REAL(0.0), REAL(0.13985269574463833395),
    REAL(0.0), REAL(0.064742483084434846635), REAL(0.0)};

typedef struct {
  real position;
  real step;
  real integral;
  real error;  // absolute, estimated
  int panels;
} March;

FN March march_begin(real first_step)
{
  March march;
  march.position = REAL(0.0);
  march.step = first_step;
  march.integral = REAL(0.0);
  march.error = REAL(0.0);
  march.panels = 0;
  return march;
}

FN int march_unfinished(March march)
{
  return march.position < REAL(1.0);
}

// Takes a panel's two estimates (over a unit interval) and accepts it or shortens the
// step: its error may be `tolerance`, relative, or `negligible`, absolute. The error follows QUADPACK: (200 |K - G|/K)^1.5 K, the Kronrod rule's own error
// being far below its difference from the Gauss rule; but no less than a hundredth of it, for integrands that are not smooth.
FN March march_advance(March march, real kronrod, real gauss, real largest_step, real tolerance, real negligible)
{
  const real value = kronrod * march.step;
  const real difference = fabs(kronrod - gauss) * march.step;
  real error = REAL(0.0);
  if (difference > REAL(0.0)) {
    const real ratio = REAL(200.0) * difference / value;
    error = ratio < REAL(1.0) ? fmax(value * ratio * sqrt(ratio), REAL(0.01) * difference) : fmax(difference, value);
  }
  march.panels += 1;
  if (!isfinite(value)) {
    march.integral = value;
    march.position = REAL(1.0);
  } else if (error <= fmax(tolerance * (value + march.integral), negligible) || march.step <= SMALLEST_PANEL || march.panels > MOST_PANELS) {
    march.integral += value;
    march.error += error;
    march.position += march.step;
    march.step = fmin(march.step * REAL(2.0), largest_step);
    // The remainder is one panel when it is not much longer than the step; no sliver is left.
    const real left = REAL(1.0) - march.position;
    if (left < march.step * REAL(1.5))
      march.step = left;
    if (left <= REAL_EPSILON * REAL(4.0))
      march.position = REAL(1.0);
  } else {
    march.step *= REAL(0.5);
  }
  return march;
}

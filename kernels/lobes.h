// Shape of a lobe: the distance of Eq. (12), the foreshortened and shadowed
// width rho', and the Lorentzian or Gaussian profile.
#pragma once
#include "angles.h"
#include "dialect.h"
#include "material.h"

FN scalar lobe_rho2(int lobe, MaterialConstants m) {
  return lobe == LOBE_SURFACE ? m.rho2_surface : lobe == LOBE_BULK ? m.rho2_bulk : m.rho2_retro;
}

// The square of the foreshortening factor (mu_i + mu_s)/2, Eq. (9).
FN real foreshortening2(real mu_i, real mu_s, ModelVariant variant) {
  const real mean = REAL(0.5) * (mu_i + mu_s);
  return variant.foreshortening ? mean * mean : REAL(1.0);
}

// (alpha - alpha_0)^2 + beta^2 = axial + transverse sin^2(phi/2); for the retro
// lobe, centred at -alpha_0, with cos^2(phi/2). All terms are positive.
typedef struct {
  real axial;       // (sin theta_s - sin theta_i)^2
  real transverse;  // 4 sin theta_i sin theta_s
} LobeDistance;

FN LobeDistance lobe_distance(real theta_i, real theta_s, real sine_i, real sine_s) {
  const SineCosine half_sum = sincos_degrees(REAL(0.5) * (theta_s + theta_i));
  const SineCosine half_difference = sincos_degrees(REAL(0.5) * (theta_s - theta_i));
  const real difference = REAL(2.0) * half_sum.cosine * half_difference.sine;
  LobeDistance d;
  d.axial = difference * difference;
  d.transverse = REAL(4.0) * sine_i * sine_s;
  return d;
}

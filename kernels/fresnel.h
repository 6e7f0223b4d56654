// Fresnel reflection at a medium of complex index m = n_eff + i k_eff, Eq. (15).
#pragma once
#include "dialect.h"
#include "material.h"

typedef struct {
  real modulus_s;        // sqrt(R_s)
  real modulus_p;        // sqrt(R_p)
  real transmittance_s;  // 1 - R_s
  real transmittance_p;  // 1 - R_p
} Fresnel;

// With c = cos, s = sin and q = sqrt(m^2 - s^2), Eq. (15) reads
// r_s = (c - q)/(c + q) and r_p = (m^2 c - q)/(m^2 c + q). Multiplied out with
// the conjugate factor,
//   r_s = (1 - m^2)/(c + q)^2,   r_p = (m^2 - 1)(m^2 c^2 - s^2)/(m^2 c + q)^2,
//   1 - R_s = 4 c Re(q)/|c + q|^2,
//   1 - R_p = 4 c Re(q) (|q|^2 + s^2)/|m^2 c + q|^2,
// so neither R nor 1 - R cancels: R is exactly 0 for m = 1, and 1 - R exactly 0
// under total reflection.
FN_SHARED Fresnel fresnel(real s, real c, MaterialConstants m) {
  const real q2_re = (m.n_eff - s) * (m.n_eff + s) - m.k_eff * m.k_eff;
  const scalar q2_im = m.m2_im;
  const real q_norm = sqrt(q2_re * q2_re + q2_im * q2_im);
  const real larger = sqrt(REAL(0.5) * (q_norm + fabs(q2_re)));
  const real smaller = larger > REAL(0.0) ? REAL(0.5) * q2_im / larger : REAL(0.0);
  const real q_re = q2_re >= REAL(0.0) ? larger : smaller;
  const real q_im = q2_re >= REAL(0.0) ? smaller : larger;

  const real s_re = c + q_re;
  const real s_norm = s_re * s_re + q_im * q_im;
  const real p_re = m.m2_re * c + q_re;
  const real p_im = m.m2_im * c + q_im;
  const real p_norm = p_re * p_re + p_im * p_im;
  const real nc = m.n_eff * c;
  const real kc = m.k_eff * c;
  const real brewster_re = (nc - s) * (nc + s) - kc * kc;
  const real brewster_im = m.m2_im * c * c;

  Fresnel f;
  f.modulus_s = m.contrast / s_norm;
  f.modulus_p = m.contrast * sqrt(brewster_re * brewster_re + brewster_im * brewster_im) / p_norm;
  f.transmittance_s = REAL(4.0) * c * q_re / s_norm;
  f.transmittance_p = REAL(4.0) * c * q_re * (q_norm + s * s) / p_norm;
  return f;
}

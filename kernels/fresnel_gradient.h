// Logarithmic derivatives of the Fresnel coefficients of Eq. (15) by the complex index m = n_eff + i k_eff.
#pragma once
#include "dialect.h"
#include "material.h"

typedef struct {
  real re;
  real im;
} Complex;

FN Complex complex_number(real re, real im) {
  Complex z;
  z.re = re;
  z.im = im;
  return z;
}

FN Complex complex_product(Complex a, Complex b) {
  return complex_number(a.re * b.re - a.im * b.im, fma(a.re, b.im, a.im * b.re));
}

// a / b; 0 where b is 0.
FN Complex complex_quotient(Complex a, Complex b) {
  const real norm = fmax(b.re * b.re + b.im * b.im, REAL_SMALLEST);
  return complex_number(fma(a.re, b.re, a.im * b.im) / norm, fma(a.im, b.re, -a.re * b.im) / norm);
}

typedef struct {
  Complex s;
  Complex p;
} FresnelGradient;

// With q = sqrt(m^2 - s^2) and r_s = (c - q)/(c + q), r_p = (m^2 c - q)/(m^2 c + q):
//   d ln r_s/dm = 2 c m/(q (m^2 - 1)),   d ln r_p/dm = d ln r_s/dm (m^2 - 2 s^2)/(m^2 c^2 - s^2).
// d ln|r|/dn_eff is the real part, d ln|r|/dk_eff minus the imaginary one. Where r = 0 or q = 0, |r| has a
// kink and the derivative given is 0.
FN FresnelGradient fresnel_gradient(real s, real c, MaterialConstants m) {
  const real q2_re = (m.n_eff - s) * (m.n_eff + s) - m.k_eff * m.k_eff;
  const scalar q2_im = m.m2_im;
  const real q_norm = sqrt(q2_re * q2_re + q2_im * q2_im);
  const real larger = sqrt(REAL(0.5) * (q_norm + fabs(q2_re)));
  const real smaller = larger > REAL(0.0) ? REAL(0.5) * q2_im / larger : REAL(0.0);
  const Complex q =
      complex_number(q2_re >= REAL(0.0) ? larger : smaller, q2_re >= REAL(0.0) ? smaller : larger);
  const Complex contrast = complex_number(
      WIDE((m.n_eff - SCALAR(1.0)) * (m.n_eff + SCALAR(1.0)) - m.k_eff * m.k_eff), WIDE(m.m2_im));
  const real nc = m.n_eff * c;
  const real kc = m.k_eff * c;
  const Complex brewster = complex_number((nc - s) * (nc + s) - kc * kc, m.m2_im * c * c);
  const Complex numerator = complex_number(REAL(2.0) * nc, REAL(2.0) * kc);
  FresnelGradient f;
  f.s = complex_quotient(numerator, complex_product(q, contrast));
  f.p = complex_product(
      f.s, complex_quotient(complex_number(m.m2_re - REAL(2.0) * s * s, WIDE(m.m2_im)), brewster));
  return f;
}

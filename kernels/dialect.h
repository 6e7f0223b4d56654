// The only file that knows which language compiles the maths: OpenCL C 1.2,
// or C++ (tests compile the same files with real = double and real = float).
#pragma once

#ifdef __OPENCL_C_VERSION__

#pragma OPENCL FP_CONTRACT OFF
#if BRDFTAB_WORKING_DOUBLE || BRDFTAB_TABLE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif

#if BRDFTAB_WORKING_DOUBLE
typedef double real;
#define REAL(literal) literal
#define AS_REAL(bits) as_double((long)(bits))
#else
typedef float real;
#define REAL(literal) literal##f
#define AS_REAL(bits) as_float((int)(bits))
#endif

#define FN static inline
// Where a loop around the call is to be vectorised.
#define FN_INLINED static inline __attribute__((always_inline))
// Large functions that are called from several places: one copy each, or drivers compile for seconds.
#define FN_SHARED static __attribute__((noinline))
#define CONSTANT __constant

#else

#include <bit>
#include <cmath>
#include <cstdint>
using std::exp, std::expm1, std::fabs, std::fma, std::fmax, std::fmin, std::isfinite, std::log, std::log1p, std::rint, std::sqrt;
#define REAL(literal) static_cast<real>(literal)
#define FN inline
#define FN_INLINED inline __attribute__((always_inline))
#define FN_SHARED inline
#define CONSTANT static constexpr
#if BRDFTAB_WORKING_DOUBLE
#define AS_REAL(bits) std::bit_cast<double>(static_cast<std::int64_t>(bits))
#else
#define AS_REAL(bits) std::bit_cast<float>(static_cast<std::int32_t>(bits))
#endif

#endif

#if BRDFTAB_WORKING_DOUBLE
#define REAL_EPSILON REAL(2.220446049250313e-16)
#define REAL_SMALLEST REAL(1e-300)
#define EXPONENT_RANGE REAL(708.0)
#define LN2_HIGH REAL(6.93147180369123816490e-01)
#define LN2_LOW REAL(1.90821492927058770002e-10)
// 2^n for an integral n: the biased exponent, moved to its place.
#define POWER_OF_TWO_BITS(n) (((long)(n) + 1023) << 52)
// Relative tolerances asked of each panel: of N, of DHR over theta_s, and of DHR over phi;
// the length of a panel that is accepted as it is; and an error of DHR that does not matter.
#define PANEL_TOLERANCE REAL(1e-13)
#define DHR_TOLERANCE REAL(1e-11)
#define RING_TOLERANCE REAL(5e-9)
#define SMALLEST_PANEL REAL(1e-9)
#define NEGLIGIBLE_DHR REAL(1e-22)
// ln of the smallest rho'^2 that the integral over a lobe resolves; its square must not underflow.
#define LN_RHO2_FLOOR REAL(-460.0)
#else
#define REAL_EPSILON REAL(1.1920929e-7)
#define REAL_SMALLEST REAL(1e-37)
#define EXPONENT_RANGE REAL(87.0)
#define LN2_HIGH REAL(6.93145751953125e-01)
#define LN2_LOW REAL(1.42860682030941723212e-06)
#define POWER_OF_TWO_BITS(n) (((int)(n) + 127) << 23)
#define PANEL_TOLERANCE REAL(1e-6)
#define DHR_TOLERANCE REAL(1e-5)
#define RING_TOLERANCE REAL(3e-6)
#define SMALLEST_PANEL REAL(1e-4)
#define NEGLIGIBLE_DHR REAL(1e-16)
#define LN_RHO2_FLOOR REAL(-69.0)
#endif

#define PI REAL(3.14159265358979323846)

FN_INLINED real power_of_two(real n)
{
  return AS_REAL(POWER_OF_TWO_BITS(n));
}

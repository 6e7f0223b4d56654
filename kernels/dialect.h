// The only file that knows which language compiles the maths: OpenCL C 1.2,
// or C++ (tests and the host compile the same files with real = double and real = float).
//
// `scalar` is a number; `real` is BRDFTAB_WIDTH of them, one for each of as many directions. The maths holds
// for any width: it selects instead of branching on a `real`, and loops as long as the material asks, not the
// direction.
#pragma once

#ifdef __OPENCL_C_VERSION__

#pragma OPENCL FP_CONTRACT OFF
#if BRDFTAB_WORKING_DOUBLE || BRDFTAB_TABLE_DOUBLE
#pragma OPENCL EXTENSION cl_khr_fp64 : enable
#endif

#if BRDFTAB_WORKING_DOUBLE
typedef double scalar;
typedef long scalar_bits;
#define SCALAR(literal) literal
#define WIDE_REAL(width) double##width
#define WIDE_BITS(width) long##width
#define AS_WIDE_REAL(width) as_double##width
#define AS_WIDE_BITS(width) as_long##width
#else
typedef float scalar;
typedef int scalar_bits;
#define SCALAR(literal) literal##f
#define WIDE_REAL(width) float##width
#define WIDE_BITS(width) int##width
#define AS_WIDE_REAL(width) as_float##width
#define AS_WIDE_BITS(width) as_int##width
#endif

#define FN static inline
// Where a loop around the call is to be vectorised.
#define FN_INLINED static inline __attribute__((always_inline))
#define CONSTANT __constant

#if BRDFTAB_WIDTH > 1
#define EXPANDED(macro, width) macro(width)
typedef EXPANDED(WIDE_REAL, BRDFTAB_WIDTH) real;
typedef EXPANDED(WIDE_BITS, BRDFTAB_WIDTH) bits;
#define AS_REAL EXPANDED(AS_WIDE_REAL, BRDFTAB_WIDTH)
#define AS_BITS EXPANDED(AS_WIDE_BITS, BRDFTAB_WIDTH)
#define WIDE_LOAD(width) vload##width
#define WIDE_STORE(width) vstore##width
#define LOAD EXPANDED(WIDE_LOAD, BRDFTAB_WIDTH)
#define STORE EXPANDED(WIDE_STORE, BRDFTAB_WIDTH)
#define FN_SHARED FN
#else
typedef scalar real;
typedef scalar_bits bits;
#define AS_REAL AS_WIDE_REAL()
#define AS_BITS AS_WIDE_BITS()
#define LOAD(k, numbers) ((numbers)[k])
#define STORE(number, k, numbers) ((numbers)[k] = (number))
// Large functions that are called from several places: one copy each, or drivers compile for seconds.
#define FN_SHARED static __attribute__((noinline))
#endif
#define WIDE(number) ((real)(number))

#else

#include <bit>
#include <cmath>
#include <cstdint>
using std::fabs, std::fma, std::fmax, std::fmin, std::isfinite, std::rint, std::sqrt;
typedef real scalar;
#define SCALAR(literal) static_cast<scalar>(literal)
#define WIDE(number) (number)
#define FN inline
#define FN_INLINED inline __attribute__((always_inline))
#define FN_SHARED inline
#define CONSTANT static constexpr
#if BRDFTAB_WORKING_DOUBLE
typedef std::int64_t bits;
#else
typedef std::int32_t bits;
#endif
#define AS_REAL(pattern) std::bit_cast<real>(pattern)
#define AS_BITS(number) std::bit_cast<bits>(number)
#define BRDFTAB_WIDTH 1
#define LOAD(k, numbers) ((numbers)[k])
#define STORE(number, k, numbers) ((numbers)[k] = (number))

#endif

#define REAL(literal) WIDE(SCALAR(literal))

#if BRDFTAB_WORKING_DOUBLE
#define REAL_EPSILON SCALAR(2.220446049250313e-16)
#define REAL_SMALLEST REAL(1e-300)
#define EXPONENT_RANGE REAL(708.0)
#define LN2_HIGH REAL(6.93147180369123816490e-01)
#define LN2_LOW REAL(1.90821492927058770002e-10)
#define MANTISSA_BITS 52
#define EXPONENT_BIAS SCALAR(1023.0)
#define SQRT_HALF_BITS 0x3fe6a09e667f3bcd
// A number n below 2^50, added to this, leaves n in the lowest bits of the sum.
#define ROUNDING SCALAR(6755399441055744.0)
// Relative tolerances asked of each panel: of N, of DHR over theta_s, and of DHR over phi;
// the length of a panel that is accepted as it is; and an error of DHR that does not matter.
#define PANEL_TOLERANCE SCALAR(1e-13)
#define DHR_TOLERANCE REAL(1e-11)
#define RING_TOLERANCE REAL(5e-9)
#define SMALLEST_PANEL SCALAR(1e-9)
#define NEGLIGIBLE_DHR REAL(1e-22)
// ln of the smallest rho'^2 that the integral over a lobe resolves; its square must not underflow.
#define LN_RHO2_FLOOR REAL(-460.0)
#else
#define REAL_EPSILON SCALAR(1.1920929e-7)
#define REAL_SMALLEST REAL(1e-37)
#define EXPONENT_RANGE REAL(87.0)
#define LN2_HIGH REAL(6.93145751953125e-01)
#define LN2_LOW REAL(1.42860682030941723212e-06)
#define MANTISSA_BITS 23
#define EXPONENT_BIAS SCALAR(127.0)
#define SQRT_HALF_BITS 0x3f3504f3
#define ROUNDING SCALAR(12582912.0)
#define PANEL_TOLERANCE SCALAR(1e-6)
#define DHR_TOLERANCE REAL(1e-5)
#define RING_TOLERANCE REAL(3e-6)
#define SMALLEST_PANEL SCALAR(1e-4)
#define NEGLIGIBLE_DHR REAL(1e-16)
#define LN_RHO2_FLOOR REAL(-69.0)
#endif

#define PI REAL(3.14159265358979323846)

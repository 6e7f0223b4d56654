// How many bits of each sample's mantissa a table keeps.
#pragma once

#include <cmath>

#include "host/compute/opencl/engine.hpp"
#include "host/compute/slab.hpp"

namespace brdftab {

/// Explicit bits of a mantissa: all that can be kept.
constexpr int mantissa_bits(Precision precision) { return precision == Precision::float64 ? 52 : 23; }

/// Throws BadInput unless `keep_bits` lies in 1 to mantissa_bits.
void check_keep_bits(int keep_bits, Precision precision);

/// The largest relative error that rounding to `keep_bits` explicit bits adds.
inline double rounding_error(int keep_bits) { return std::ldexp(1.0, -(keep_bits + 1)); }

/// Enqueues the rounding, in place, of a slab's samples in the table's precision: to nearest, ties to even.
/// Subnormal numbers, and numbers that would round to infinity, stay as they are, so that `rounding_error`
/// holds for all.
void round_mantissas(const Engine& engine, const Slab& slab, const cl::Buffer& samples, int keep_bits);

}  // namespace brdftab

#include "host/compute/rounding.hpp"

#include "host/base/error.hpp"

namespace brdftab {

void check_keep_bits(int keep_bits, Precision precision) {
  if (keep_bits < 1 || keep_bits > mantissa_bits(precision))
    throw BadInput("--keep-bits {}: must lie in 1 to {}, the explicit bits of a {} mantissa", keep_bits,
                   mantissa_bits(precision), name_of(precision));
}

void round_mantissas(const Engine& engine, const Slab& slab, const cl::Buffer& samples, int keep_bits) {
  const int dropped = mantissa_bits(engine.table()) - keep_bits;
  if (dropped == 0) return;
  cl::Kernel kernel = engine.kernel("round_mantissas");
  set_arguments(kernel, samples, static_cast<cl_int>(slab.phi_s), static_cast<cl_int>(dropped));
  engine.run(kernel, {slab.phi_s, slab.nodes() / slab.phi_s, 1});
}

}  // namespace brdftab

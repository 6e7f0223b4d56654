// f of a list of direction pairs, by the kernels or by the scalar reference.
#pragma once

#include <span>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/model/direction_list.hpp"
#include "host/model/material.hpp"

namespace brdftab {

/// f in 1/sr.
struct PolarizedBrdf {
  double s;
  double p;
  double unpolarized() const { return 0.5 * (s + p); }
};

/// In the order of the pairs; infinite where a lobe exceeds the precision.
std::vector<PolarizedBrdf> evaluate(const Engine& engine, const Band& band, const Variant& variant,
                                    std::span<const DirectionPair> pairs);

std::vector<PolarizedBrdf> evaluate_reference(const Band& band, const Variant& variant,
                                              std::span<const DirectionPair> pairs, const Watch& watch = {});

}  // namespace brdftab

// f depends on phi_s - phi_i alone: the axis of their differences, and where each row of phi_s lies on it.
#pragma once

#include <vector>

#include "host/model/axis.hpp"

namespace brdftab {

/// Nodes of one row of phi_s, from `phi_s` on, that lie at even steps of the axis of differences.
struct AzimuthPiece {
  std::size_t phi_i;
  std::size_t phi_s;
  std::size_t phi;   // the node of the first
  std::size_t step;  // nodes of phi from one to the next
  std::size_t count;
};

struct RelativeAzimuth {
  Axis phi;  // in (-180, 180]: every phi_s - phi_i modulo 360, each exactly as a table of all four angles
             // evaluates it
  std::vector<AzimuthPiece> pieces;  // in the order of phi_i and phi_s, at most two for each phi_i
};

/// Throws BadInput where rows do not share the nodes of one axis so.
RelativeAzimuth relative_azimuth(const Axis& phi_i, const Axis& phi_s);

}  // namespace brdftab

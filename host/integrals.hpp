// Hemispherical integrals of a material over its angles of incidence, from the device.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/normalizations.hpp"

namespace brdftab {

struct Integrals {
  Normalizations normalization;
};

}  // namespace brdftab

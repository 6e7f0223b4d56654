// The structs of material_constants.h, once, in the working precision.
#pragma once
#include "dialect.h"
#include "material_constants.h"

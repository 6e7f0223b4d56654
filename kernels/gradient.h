// The struct of gradient_constants.h, once, in the working precision.
#pragma once
#include "material.h"
#include "gradient_constants.h"

// The OpenCL host API with exceptions, at the version that the kernels need.
#pragma once

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#define CL_TARGET_OPENCL_VERSION 120
#include <CL/opencl.hpp>

#include <string>

namespace brdftab {

/// "the kernels do not build (clBuildProgram, -11)".
std::string describe(const cl::Error& error);

}  // namespace brdftab

// The OpenCL devices of this machine, and the choice of one.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "host/compute/opencl/opencl.hpp"

namespace brdftab {

struct Device {
  std::size_t index;     // over all platforms
  std::size_t platform;  // index of its platform
  std::size_t ordinal;   // within its platform
  std::string platform_name;
  std::string name;
  std::string driver;
  std::string opencl_version;
  bool is_gpu;
  bool has_fp64;
  unsigned compute_units;
  std::size_t memory_bytes;
  std::size_t largest_buffer_bytes;
  std::size_t largest_work_group;
  cl::Device handle;

  /// As tables and messages name it.
  std::string description() const;
};

/// All devices, in the order of platforms. Throws Error (exit status 3) where there is none, with the cause
/// and what to install or set. Chooses PoCL's cache folder first: see pocl_cache.hpp.
std::vector<Device> list_devices();

/// The device that `selector` names: an index, a platform:device pair, or part of a name. Without one,
/// BRDFTAB_DEVICE; without that, the first GPU, or the first device.
/// Throws Error (exit status 3) where there is none, or where it names all.
Device select_device(const std::optional<std::string>& selector);

/// The same, and `all`: every device that has the widest precision among them.
std::vector<Device> select_devices(const std::optional<std::string>& selector);

}  // namespace brdftab

#include "host/compute/opencl/device.hpp"

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/opencl/driver_abort.hpp"
#include "host/compute/opencl/pocl_cache.hpp"

namespace brdftab {
namespace {

constexpr int platform_not_found = -1001;  // CL_PLATFORM_NOT_FOUND_KHR, of the loader's extension

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  return result;
}

Device describe_device(cl::Device handle, const std::string& platform_name, std::size_t platform,
                       std::size_t ordinal) {
  return {.index = 0,
          .platform = platform,
          .ordinal = ordinal,
          .platform_name = platform_name,
          .name = std::string(trimmed(handle.getInfo<CL_DEVICE_NAME>())),
          .driver = handle.getInfo<CL_DRIVER_VERSION>(),
          .opencl_version = std::string(trimmed(handle.getInfo<CL_DEVICE_VERSION>())),
          .is_gpu = (handle.getInfo<CL_DEVICE_TYPE>() & CL_DEVICE_TYPE_GPU) != 0,
          .has_fp64 = handle.getInfo<CL_DEVICE_DOUBLE_FP_CONFIG>() != 0,
          .compute_units = handle.getInfo<CL_DEVICE_MAX_COMPUTE_UNITS>(),
          .memory_bytes = handle.getInfo<CL_DEVICE_GLOBAL_MEM_SIZE>(),
          .largest_buffer_bytes = handle.getInfo<CL_DEVICE_MAX_MEM_ALLOC_SIZE>(),
          .largest_work_group = handle.getInfo<CL_DEVICE_MAX_WORK_GROUP_SIZE>(),
          .handle = handle};
}

[[noreturn]] void no_device(const std::string& cause) {
  throw Error(Fault::device,
              "no OpenCL device: {}; install a driver (Debian: pocl-opencl-icd for the CPU, or the GPU's "
              "own), and unset OCL_ICD_VENDORS and POCL_DEVICES if they hide it",
              cause);
}

constexpr std::string_view all_devices = "all";

std::string wanted_device(const std::optional<std::string>& selector) {
  const char* variable = std::getenv("BRDFTAB_DEVICE");
  return selector ? *selector : variable ? variable : "";
}

}  // namespace

std::string Device::description() const {
  return fmt::format("{} ({}, {}, driver {})", name, platform_name, opencl_version, driver);
}

std::vector<Device> list_devices() {
  choose_pocl_cache();
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error& error) {
    if (error.err() != platform_not_found) throw;
  }
  if (platforms.empty()) no_device("no OpenCL platform is installed");
  std::vector<Device> devices;
  for (std::size_t p = 0; p < platforms.size(); ++p) {
    std::vector<cl::Device> handles;
    try {
      platforms[p].getDevices(CL_DEVICE_TYPE_ALL, &handles);
    } catch (const cl::Error& error) {
      if (error.err() != CL_DEVICE_NOT_FOUND) throw;
    }
    const std::string name(trimmed(platforms[p].getInfo<CL_PLATFORM_NAME>()));
    for (std::size_t d = 0; d < handles.size(); ++d)
      devices.push_back(describe_device(handles[d], name, p, d));
  }
  catch_driver_abort();
  if (devices.empty())
    no_device(
        fmt::format("platform {} has none", std::string(trimmed(platforms[0].getInfo<CL_PLATFORM_NAME>()))));
  for (std::size_t k = 0; k < devices.size(); ++k) devices[k].index = k;
  return devices;
}

std::vector<Device> select_devices(const std::optional<std::string>& selector) {
  if (wanted_device(selector) != all_devices) return {select_device(selector)};
  auto devices = list_devices();
  // One table has one arithmetic.
  if (std::any_of(devices.begin(), devices.end(), [](const Device& d) { return d.has_fp64; }))
    std::erase_if(devices, [](const Device& d) { return !d.has_fp64; });
  return devices;
}

Device select_device(const std::optional<std::string>& selector) {
  const auto devices = list_devices();
  const std::string wanted = wanted_device(selector);
  if (wanted == all_devices)
    throw Error(Fault::device, "--device all: this command runs on one device; name it");
  if (wanted.empty()) {
    const auto gpu = std::find_if(devices.begin(), devices.end(), [](const Device& d) { return d.is_gpu; });
    return gpu != devices.end() ? *gpu : devices.front();
  }
  for (const auto& device : devices)
    if (wanted == std::to_string(device.index) ||
        wanted == fmt::format("{}:{}", device.platform, device.ordinal))
      return device;
  for (const auto& device : devices)
    if (lower(device.platform_name + " " + device.name).find(lower(wanted)) != std::string::npos)
      return device;
  std::vector<std::string> known;
  for (const auto& device : devices)
    known.push_back(
        fmt::format("{} ({}:{}, {})", device.index, device.platform, device.ordinal, device.name));
  throw Error(Fault::device, "no OpenCL device is called '{}'; there is {}", excerpt(wanted),
              fmt::join(known, "; "));
}

std::string describe(const cl::Error& error) {
  std::string_view cause;
  switch (error.err()) {
    case CL_DEVICE_NOT_AVAILABLE:
      cause = "the device is not available";
      break;
    case CL_COMPILER_NOT_AVAILABLE:
      cause = "the driver has no compiler";
      break;
    case CL_MEM_OBJECT_ALLOCATION_FAILURE:
      cause = "the device has too little memory";
      break;
    case CL_OUT_OF_RESOURCES:
      cause = "the device is out of resources";
      break;
    case CL_OUT_OF_HOST_MEMORY:
      cause = "the host is out of memory";
      break;
    case CL_BUILD_PROGRAM_FAILURE:
      cause = "the kernels do not build";
      break;
    case CL_INVALID_BUFFER_SIZE:
      cause = "a buffer is larger than the device allows";
      break;
    case CL_INVALID_WORK_GROUP_SIZE:
      cause = "a work-group is larger than the device allows";
      break;
    default:
      cause = "OpenCL error";
      break;
  }
  return fmt::format("{} ({}, {})", cause, error.what(), error.err());
}

}  // namespace brdftab

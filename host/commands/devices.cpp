#include "host/commands/command.hpp"
#include "host/compute/opencl/device.hpp"

namespace brdftab {

std::function<ExitStatus()> devices_command(CLI::App&, const CommonOptions&) {
  return [] {
    const Device preferred = select_device(std::nullopt);
    for (const Device& device : list_devices()) {
      fmt::print("{}  {}:{}  {}{}\n", device.index, device.platform, device.ordinal, device.name,
                 device.index == preferred.index ? "  (default)" : "");
      fmt::print("     {}, {}, driver {}\n", device.platform_name, device.opencl_version, device.driver);
      fmt::print("     {}, {} compute units, {:.1f} GiB, largest buffer {:.1f} GiB, {}\n",
                 device.is_gpu ? "GPU" : "CPU or other", device.compute_units,
                 static_cast<double>(device.memory_bytes) / (1u << 30),
                 static_cast<double>(device.largest_buffer_bytes) / (1u << 30),
                 device.has_fp64 ? "fp64" : "no fp64: float32 tables, computed in float32");
    }
    fmt::print(
        "\nSelect one with --device or BRDFTAB_DEVICE: its index ({}), platform:device ({}:{}), or part of "
        "its name.\n",
        preferred.index, preferred.platform, preferred.ordinal);
    return ExitStatus::done;
  };
}

}  // namespace brdftab

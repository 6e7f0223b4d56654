#include "host/commands/command.hpp"

#include <cstdio>

namespace brdftab {

void add_device_option(CLI::App& parser, std::optional<std::string>& device) {
  parser.add_option("--device", device,
                    "OpenCL device: its index, platform:device, or part of its name (see brdftab devices; BRDFTAB_DEVICE "
                    "does the same)");
}

void say(const CommonOptions& common, const std::string& line) {
  if (!common.quiet) fmt::print(stderr, "brdftab: {}\n", line);
}

}  // namespace brdftab

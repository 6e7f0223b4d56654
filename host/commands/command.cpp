#include "host/commands/command.hpp"

#include <algorithm>
#include <cstdio>
#include <regex>

#include "host/base/numbers.hpp"

namespace brdftab {

void add_device_option(CLI::App& parser, std::optional<std::string>& device, bool several) {
  parser.add_option(
      "--device", device,
      fmt::format("OpenCL device: its index, platform:device, or part of its name{} (see brdftab devices; "
                  "BRDFTAB_DEVICE does the same)",
                  several ? "; or all: every one, but none without fp64 beside those that have it" : ""));
}

void add_engine_options(CLI::App& parser, std::string& engine, std::string& precision) {
  parser.add_option("--engine", engine, "opencl, or reference: the scalar code")
      ->check(CLI::IsMember({"opencl", "reference"}));
  parser
      .add_option("--precision", precision,
                  "Arithmetic of the kernels: float64 (default where the device has it) or float32")
      ->check(CLI::IsMember({"float32", "float64"}));
}

Precision working_precision(const std::string& option, const Device& device) {
  if (option.empty()) return Engine::widest(device);
  return option == "float32" ? Precision::float32 : Precision::float64;
}

std::string option_name(std::string_view setting) {
  std::string name = fmt::format("--{}", setting);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

Axis parse_axis_option(AxisKind kind, const std::string& text) {
  try {
    return Axis::parse(kind, text);
  } catch (const BadInput& error) {
    throw BadInput("{} {}: {}", option_name(axis_row(kind).name), excerpt(text), error.what());
  }
}

std::string spelled(std::string_view message) {
  static const std::regex setting("`([a-z][a-z0-9_]*)`");
  std::string result;
  auto rest = message.begin();
  for (std::cregex_iterator at(message.begin(), message.end(), setting), end; at != end; ++at) {
    result.append(rest, (*at)[0].first);
    result += option_name((*at)[1].str());
    rest = (*at)[0].second;
  }
  return result.append(rest, message.end());
}

void say(const CommonOptions& common, const std::string& line) {
  if (!common.quiet) fmt::print(stderr, "brdftab: {}\n", spelled(line));
}

}  // namespace brdftab

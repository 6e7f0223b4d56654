// A subcommand of the program: a row of the table in main.cpp.
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <optional>
#include <string>

#include "host/base/watch.hpp"
#include "host/commands/exit_status.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/model/axis.hpp"

namespace brdftab {

/// Options that every command has.
struct CommonOptions {
  bool quiet = false;
  /// The command line, for a table's history.
  std::string command_line;
  /// What the library tells, and the signals that end its work.
  Watch watch;
};

/// Adds a command's options to its parser, and returns what runs it once they are parsed.
using Command = std::function<ExitStatus()> (*)(CLI::App& parser, const CommonOptions& common);

std::function<ExitStatus()> generate_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> evaluate_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> integrate_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> fit_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> validate_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> plot_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> report_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> info_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> bench_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> devices_command(CLI::App&, const CommonOptions&);
std::function<ExitStatus()> parameters_command(CLI::App&, const CommonOptions&);

/// `several`: the command takes `all`.
void add_device_option(CLI::App& parser, std::optional<std::string>& device, bool several = false);

/// --engine opencl|reference and --precision float32|float64.
void add_engine_options(CLI::App& parser, std::string& engine, std::string& precision);

/// What --precision asks for; without it, the widest that the device has.
Precision working_precision(const std::string& option, const Device& device);

/// The option of a setting of the library: `--theta-i` for theta_i.
std::string option_name(std::string_view setting);
/// The axis that such an option gives. Throws BadInput that names the option.
Axis parse_axis_option(AxisKind kind, const std::string& text);

/// A message of the library with its settings as options: `keep_bits` becomes --keep-bits.
std::string spelled(std::string_view message);

/// A line of talk on standard error, unless quiet.
void say(const CommonOptions& common, const std::string& line);

}  // namespace brdftab

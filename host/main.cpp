// The command line: a table of commands, and the one place where errors end.
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <new>

#include "host/commands/command.hpp"
#include "host/commands/interruption.hpp"
#include "host/commands/progress_bar.hpp"
#include "host/compute/opencl/opencl.hpp"
#include "host/compute/opencl/pocl_cache.hpp"
#include "host/formats/hdf5/hdf5_exit.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

struct CommandRow {
  const char* name;
  const char* summary;
  Command command;
};

constexpr CommandRow command_table[] = {
    {"generate", "Tabulate materials into table files", generate_command},
    {"evaluate", "Evaluate a material at the directions of a CSV file", evaluate_command},
    {"integrate", "Integrate a material over the hemisphere: N, DHR and BHR", integrate_command},
    {"fit", "Fit the fourteen parameters to a measured BRDF", fit_command},
    {"validate", "Read a table back and compare it with the scalar reference", validate_command},
    {"plot", "Draw a material or a table: curves, maps, shadowing, reflectance, comparison", plot_command},
    {"report", "Write a page about a table or a material: pictures, figures, a map with a slider",
     report_command},
    {"info", "Show what a table holds", info_command},
    {"bench", "Measure kernels against the device's store rate and the scalar reference", bench_command},
    {"devices", "List the OpenCL devices and how to select each", devices_command},
    {"parameters", "List every parameter of the model with its range and meaning", parameters_command},
};

int fail(ExitStatus status, std::string_view message) {
  std::fflush(stdout);
  // One line, whatever stands in a file's name; only a build log has more.
  std::string line(message);
  if (status != ExitStatus::device)
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  fmt::print(stderr, "brdftab: {}\n", line);
  return static_cast<int>(status);
}

std::string joined(int argc, char** argv) {
  std::string line = "brdftab";
  for (int k = 1; k < argc; ++k) {
    const std::string_view word = argv[k];
    const bool plain =
        !word.empty() &&
        word.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%") ==
            std::string_view::npos;
    line += plain ? fmt::format(" {}", word) : fmt::format(" '{}'", word);
  }
  // It stands in one line of files' comments.
  std::replace_if(
      line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return line;
}

void add_quiet(CLI::App& parser, CommonOptions& common) {
  parser.add_flag("-q,--quiet", common.quiet, "No talk on standard error but errors");
}

int run(int argc, char** argv) {
  CLI::App app{"brdftab: tables of the Renhorn-Boreman BRDF of rough surfaces, computed with OpenCL",
               "brdftab"};
  CommonOptions common;
  common.command_line = joined(argc, argv);
  app.set_version_flag("--version", program_version);
  app.require_subcommand(1);
  add_quiet(app, common);
  std::function<ExitStatus()> chosen;
  for (const auto& row : command_table) {
    CLI::App* parser = app.add_subcommand(row.name, row.summary);
    parser->set_version_flag("--version", program_version);
    add_quiet(*parser, common);
    parser->callback([&chosen, run_command = row.command(*parser, common)] { chosen = run_command; });
  }
  if (argc > 1 && argv[1][0] != '-' &&
      std::none_of(std::begin(command_table), std::end(command_table),
                   [&](const auto& row) { return row.name == std::string_view(argv[1]); })) {
    std::vector<std::string_view> names;
    for (const auto& row : command_table) names.push_back(row.name);
    return fail(ExitStatus::bad_input,
                fmt::format("there is no command '{}'; there are {}", argv[1], fmt::join(names, ", ")));
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {  // --help, --version
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    return fail(ExitStatus::bad_input,
                fmt::format("{}; see brdftab{} --help", error.what(),
                            argc > 1 && argv[1][0] != '-' ? fmt::format(" {}", argv[1]) : ""));
  }
  common.watch.stop = stop_on_signals();
  if (!common.quiet) {
    common.watch.progress = [bar = std::make_shared<ProgressBar>()](const Progress& progress) {
      bar->report(progress);
    };
    common.watch.note = [&common](std::string_view line) { say(common, std::string(line)); };
  }
  const ExitStatus status = chosen();
  if (!damaged_pocl_cache().empty()) say(common, damaged_pocl_cache());
  if (std::fflush(stdout) != 0 || std::ferror(stdout))
    return fail(ExitStatus::file, "standard output cannot be written");
  return static_cast<int>(status);
}

}  // namespace
}  // namespace brdftab

int main(int argc, char** argv) {
  using brdftab::ExitStatus;
  try {
    brdftab::keep_hdf5_from_exit();
    return brdftab::run(argc, argv);
  } catch (const brdftab::Error& error) {
    // What a signal cut short fails in ways of its own.
    if (brdftab::signalled()) return brdftab::fail(ExitStatus::interrupted, brdftab::stopped_message);
    return brdftab::fail(exit_status(error.fault()), brdftab::spelled(error.what()));
  } catch (const cl::Error& error) {
    return brdftab::fail(ExitStatus::device, brdftab::describe(error));
  } catch (const std::filesystem::filesystem_error& error) {
    return brdftab::fail(ExitStatus::file, error.what());
  } catch (const std::bad_alloc&) {
    return brdftab::fail(ExitStatus::device, "the host is out of memory");
  } catch (const std::exception& error) {
    return brdftab::fail(ExitStatus::check_failed, error.what());
  }
}

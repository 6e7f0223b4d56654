#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/commands/bench/bench_timing.hpp"
#include "host/commands/command.hpp"
#include "host/formats/hdf5/hdf5_writer.hpp"
#include "host/formats/read_material.hpp"
#include "host/table/generate.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

using Json = nlohmann::ordered_json;

// The brown vinyl of the contract's example.
constexpr const char* default_material = R"(name = "brown vinyl"
[parameters]
n_eff = 1.24
k_eff = 0.0
sigma_surface = 1.9
rho_surface = 0.45
sigma_bulk = 0.073
rho_bulk = 0.88
sigma_retro = 0.061
rho_retro = 1.9
w_a = 0.21
w_b = 0.12
gamma = 0.9
delta = 0.0
w = 2.0
n = 0.0
)";

struct Options {
  std::string material;
  std::string json;
  std::string precision = "float32";
  std::string folder = ".";
  std::optional<std::string> device;
  double table_gigabytes = 1;
  double file_gigabytes = 1;
  int rounds = 7;
};

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

void print(const Timing& timing) {
  const double seconds = timing.median();
  const Workload& work = *timing.workload;
  const std::string bytes =
      work.bytes > 0 ? fmt::format("{:8.2f} GB/s", work.bytes / seconds / 1e9) : "             ";
  fmt::print("  {:<24}{:>12.4g} s {:>12.4g} {}/s {}  {}\n", work.name, seconds, work.produced / seconds,
             work.unit, bytes, work.measures);
}

Json json_of(const Timing& timing) {
  const auto [fastest, slowest] = std::minmax_element(timing.seconds.begin(), timing.seconds.end());
  const Workload& work = *timing.workload;
  Json result{{"name", work.name},
              {"measures", work.measures},
              {"unit", work.unit},
              {"produced", work.produced},
              {"seconds_median", timing.median()},
              {"seconds_min", *fastest},
              {"seconds_max", *slowest},
              {"per_second", work.produced / timing.median()}};
  if (work.bytes > 0) {
    result["bytes"] = work.bytes;
    result["bytes_per_second"] = work.bytes / timing.median();
  }
  return result;
}

struct Ratio {
  const char* of;
  const char* to;
  bool by_bytes;
};

// What the project promises, and what is interesting beside it.
constexpr Ratio ratios[] = {{"dense", "store", true},       {"dense rows", "store rows", true},
                            {"dense", "memset", true},      {"dense", "reference", false},
                            {"direct", "reference", false}, {"direct", "reference, all threads", false},
                            {"N", "reference N", false},    {"N and DHR", "reference N and DHR", false}};

Json bench_device(const Device& device, Precision precision, const Material& material, const Options& options,
                  const Watch& watch) {
  const double start = now();
  const Engine engine(device, Engine::widest(device), precision, watch);
  const double build = now() - start;
  fmt::print("{}, {} tables; {}; build {:.3f} s\n", device.description(), name_of(precision),
             engine.build_options(), build);
  auto workloads =
      device_workloads(engine, material, static_cast<std::size_t>(options.table_gigabytes * 1e9));
  for (auto& workload : reference_workloads(material)) workloads.push_back(std::move(workload));
  const auto timings = time_in_rounds(workloads, options.rounds, watch);
  Json result{{"device", device.description()},
              {"driver", device.driver},
              {"precision", name_of(precision)},
              {"build_options", engine.build_options()},
              {"directions_width", engine.directions_width()},
              {"build_seconds", build}};
  for (const Timing& timing : timings) {
    print(timing);
    result["workloads"].push_back(json_of(timing));
  }
  const auto named = [&](std::string_view name) -> const Timing& {
    return *std::find_if(timings.begin(), timings.end(),
                         [&](const Timing& t) { return t.workload->name == name; });
  };
  for (const Ratio& ratio : ratios) {
    const double value = rate_ratio(named(ratio.of), named(ratio.to), ratio.by_bytes);
    fmt::print("  {} / {}: {:.3g} ({})\n", ratio.of, ratio.to, value, ratio.by_bytes ? "bytes" : "rate");
    result["ratios"][fmt::format("{} / {}", ratio.of, ratio.to)] = value;
  }
  return result;
}

// What a table's bytes cost without a table: write(2) of the same amount from memory, in pieces of a slab.
void write_plainly(const std::filesystem::path& file, std::size_t bytes) {
  static const std::vector<char> piece(32u << 20, 1);
  const int descriptor = open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw FileError("{}: cannot be written", file.string());
  while (bytes > 0) {
    const ssize_t written = write(descriptor, piece.data(), std::min(bytes, piece.size()));
    if (written <= 0) {
      close(descriptor);
      std::filesystem::remove(file);
      throw FileError("{}: cannot be written", file.string());
    }
    bytes -= static_cast<std::size_t>(written);
  }
  close(descriptor);
}

// The whole of `generate`, beside a plain write of the same bytes to the same folder.
Json bench_generate(const Device& device, Precision precision, const Material& material,
                    const Options& options, const Watch& watch) {
  const Engine engine(device, Engine::widest(device), precision, watch);
  Grid grid = material.grid();
  const auto nodes = static_cast<std::size_t>(options.file_gigabytes * 1e9) / bytes_of(precision);
  const std::size_t phi_s = std::max<std::size_t>(nodes / (18 * 72 * 90), 2);
  grid.theta_i = Axis::parse(AxisKind::theta_i, "0:85:5");
  grid.phi_i = Axis::parse(AxisKind::phi_i, "0:355:5");
  grid.theta_s = Axis::parse(AxisKind::theta_s, "0:89:1");
  // A whole number of steps in 5 degrees, so that rows repeat.
  grid.phi_s = Axis::parse(AxisKind::phi_s,
                           fmt::format("0:360:{}", shortest(5.0 / std::max(1.0, std::round(phi_s / 72.0)))));
  const std::size_t bytes = grid.directions() * bytes_of(precision);
  const std::filesystem::path folder = options.folder;
  const auto table = folder / fmt::format("brdftab-bench-{}.h5", getpid());
  const auto plain = folder / fmt::format("brdftab-bench-{}.bin", getpid());
  std::vector<double> generate_seconds, plain_seconds, slowdown;
  StageSeconds stages;
  for (int round = 0; round < options.rounds; ++round) {
    double start = now();
    const auto summary = generate(engine, material, grid, table, create_hdf5_writer, {});
    generate_seconds.push_back(now() - start);
    std::filesystem::remove(table);
    start = now();
    write_plainly(plain, bytes);
    plain_seconds.push_back(now() - start);
    std::filesystem::remove(plain);
    slowdown.push_back(generate_seconds.back() / plain_seconds.back());
    stages = summary.stages;
  }
  fmt::print("generate of a {:.2f} GB table: {:.3f} s; write(2) of as many bytes: {:.3f} s; ratio {:.2f}\n",
             static_cast<double>(bytes) / 1e9, median(generate_seconds), median(plain_seconds),
             median(slowdown));
  fmt::print("  plan {:.3f} s, compute {:.3f} s, transfer {:.3f} s, write {:.3f} s, write beside compute\n",
             stages.plan, stages.compute, stages.transfer, stages.write);
  return {{"bytes", bytes},
          {"generate_seconds_median", median(generate_seconds)},
          {"plain_write_seconds_median", median(plain_seconds)},
          {"ratio_median", median(slowdown)},
          {"stages_seconds",
           {{"plan", stages.plan},
            {"compute", stages.compute},
            {"transfer", stages.transfer},
            {"write", stages.write}}}};
}

ExitStatus run(const Options& options, const CommonOptions& common) {
  const Material material = options.material.empty() ? Material::parse(default_material, "built in")
                                                     : read_material(options.material);
  // What cannot be written in the end is refused at the beginning.
  std::optional<PartialFile> json;
  if (!options.json.empty()) json.emplace(options.json, false);
  std::vector<Precision> precisions;
  if (options.precision != "float64") precisions.push_back(Precision::float32);
  if (options.precision != "float32") precisions.push_back(Precision::float64);
  Json result{{"program", program_version},
              {"command", common.command_line},
              {"material", material.name()},
              {"rounds", options.rounds},
              {"hardware_threads", std::thread::hardware_concurrency()}};
  for (const Device& device : select_devices(options.device))
    for (const Precision precision : precisions) {
      if (precision == Precision::float64 && !device.has_fp64) continue;
      Json measured = bench_device(device, precision, material, options, common.watch);
      if (options.file_gigabytes > 0)
        measured["generate"] = bench_generate(device, precision, material, options, common.watch);
      result["devices"].push_back(std::move(measured));
    }
  if (json) write_whole(*json, result.dump(2) + '\n');
  return ExitStatus::done;
}

}  // namespace

std::function<ExitStatus()> bench_command(CLI::App& parser, const CommonOptions& common) {
  auto options = std::make_shared<Options>();
  parser.add_option("MATERIAL", options->material, "Material file (TOML); without one, brown vinyl");
  parser.add_option("--json", options->json, "Write every figure to this file, which must not exist");
  parser.add_option("--precision", options->precision, "float32 (default), float64, or both")
      ->check(CLI::IsMember({"float32", "float64", "both"}));
  parser.add_option("--rounds", options->rounds, "Rounds of all measurements; figures are medians (7)")
      ->check(CLI::Range(1, 1000));
  parser
      .add_option("--table", options->table_gigabytes,
                  "Size of the tables in device memory, GB (1), in whole steps of about 0.2")
      ->check(CLI::Range(0.01, 1000.0));
  parser
      .add_option("--file", options->file_gigabytes,
                  "Size of the table file, GB (1), in whole steps of 0.03; 0: none is made")
      ->check(CLI::Range(0.0, 1e5));
  parser.add_option("--folder", options->folder, "Folder for the table file, which is removed (.)")
      ->check(CLI::ExistingDirectory);
  add_device_option(parser, options->device, true);
  return [options, &common] { return run(*options, common); };
}

}  // namespace brdftab

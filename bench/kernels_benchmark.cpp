// The workloads of `brdftab bench` under Google Benchmark, for its statistics, filters and comparisons of two
// builds.
//
// usage: kernels_benchmark MATERIAL.toml [Google Benchmark's options]
#include <benchmark/benchmark.h>

#include "host/base/error.hpp"
#include "host/commands/bench/bench_workload.hpp"

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (argc != 2) {
    std::fprintf(stderr, "usage: kernels_benchmark MATERIAL.toml [Google Benchmark's options]\n");
    return 2;
  }
  try {
    using namespace brdftab;
    const Material material = Material::read(argv[1]);
    const Device device = select_device(std::nullopt);
    const Engine engine(device, Engine::widest(device), Precision::float32);
    auto workloads = device_workloads(engine, material, std::size_t{1} << 30);
    for (auto& workload : reference_workloads(material)) workloads.push_back(std::move(workload));
    benchmark::AddCustomContext("device", device.description());
    for (const Workload& workload : workloads)
      benchmark::RegisterBenchmark(workload.name.c_str(),
                                   [&workload](benchmark::State& state) {
                                     for (auto _ : state) workload.run();
                                     state.SetItemsProcessed(static_cast<std::int64_t>(workload.produced) *
                                                             static_cast<std::int64_t>(state.iterations()));
                                     if (workload.bytes > 0)
                                       state.SetBytesProcessed(static_cast<std::int64_t>(workload.bytes) *
                                                               static_cast<std::int64_t>(state.iterations()));
                                   })
          ->UseRealTime()
          ->Unit(benchmark::kMillisecond);
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "kernels_benchmark: %s\n", error.what());
    return 1;
  }
}

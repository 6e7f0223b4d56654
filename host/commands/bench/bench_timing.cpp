#include "host/commands/bench/bench_timing.hpp"

#include <algorithm>
#include <chrono>

namespace brdftab {

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double Timing::median() const { return brdftab::median(seconds); }

std::vector<Timing> time_in_rounds(const std::vector<Workload>& workloads, int rounds, const Watch& watch) {
  std::vector<Timing> timings;
  for (const Workload& workload : workloads) {
    watch.stop_if_asked();
    workload.run();
    timings.push_back({&workload, {}});
  }
  for (int round = 0; round < rounds; ++round)
    for (Timing& timing : timings) {
      watch.stop_if_asked();
      const auto start = std::chrono::steady_clock::now();
      timing.workload->run();
      timing.seconds.push_back(
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
    }
  return timings;
}

double rate_ratio(const Timing& a, const Timing& b, bool by_bytes) {
  const auto amount = [&](const Timing& t) { return by_bytes ? t.workload->bytes : t.workload->produced; };
  std::vector<double> ratios;
  for (std::size_t k = 0; k < std::min(a.seconds.size(), b.seconds.size()); ++k)
    ratios.push_back(amount(a) / a.seconds[k] / (amount(b) / b.seconds[k]));
  return median(std::move(ratios));
}

}  // namespace brdftab

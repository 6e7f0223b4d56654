// Times workloads beside each other: rounds of all of them, so that what else a machine does falls on each
// alike.
#pragma once

#include <string>
#include <vector>

#include "host/base/watch.hpp"
#include "host/commands/bench/bench_workload.hpp"

namespace brdftab {

struct Timing {
  const Workload* workload;
  std::vector<double> seconds;  // by round

  double median() const;
};

/// Runs each workload once unmeasured, then once in each round. Stops at an interruption.
std::vector<Timing> time_in_rounds(const std::vector<Workload>& workloads, int rounds, const Watch& watch);

/// The median over rounds of a's rate of production divided by b's in the same round; by bytes if `by_bytes`.
double rate_ratio(const Timing& a, const Timing& b, bool by_bytes = false);

double median(std::vector<double> values);

}  // namespace brdftab

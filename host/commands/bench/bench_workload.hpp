// The work that benchmarks time: each a function that runs to its end, and what it produced.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/model/material.hpp"

namespace brdftab {

struct Workload {
  std::string name;
  std::string measures;  // in one sentence
  std::string unit;      // of what is produced
  double produced;       // by one run
  double bytes;          // stored by one run, where that is the point; otherwise 0
  std::function<void()> run;
};

/// For one engine: tables of about `table_bytes` on the device, beside a store-only kernel and the host's
/// memset on the same bytes; lists of directions; N and DHR. The engine and the material must outlive them.
std::vector<Workload> device_workloads(const Engine& engine, const Material& material,
                                       std::size_t table_bytes);

/// The scalar reference on one thread and on all.
std::vector<Workload> reference_workloads(const Material& material);

}  // namespace brdftab

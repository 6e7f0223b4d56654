#include "host/commands/bench/bench_workload.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>

#include "host/base/parallel.hpp"
#include "host/compute/evaluate.hpp"
#include "host/compute/plan.hpp"
#include "host/reference/model.hpp"

namespace brdftab {
namespace {

constexpr std::size_t slab_bytes = 16u << 20;
constexpr std::size_t listed_directions = 1u << 20;
constexpr std::size_t reference_directions = 4000;

// Buffers of a whole table, so that nothing of it is in a cache when it is written.
struct DeviceTable {
  const Engine& engine;
  Grid grid;
  std::vector<Slab> slabs;
  std::vector<cl::Buffer> buffers;
  Plan plan;

  DeviceTable(const Engine& on, const Material& material, const Grid& nodes)
      : engine(on),
        grid(nodes),
        slabs(brdftab::slabs(grid, slab_bytes / bytes_of(on.table()))),
        plan(on, material, material.bands().front(), grid,
             integrals(on, material.bands().front(), material.variant(), grid.theta_i.nodes())) {
    for (const Slab& slab : slabs) buffers.push_back(engine.buffer(slab.nodes() * bytes_of(engine.table())));
  }

  double nodes() const { return static_cast<double>(grid.directions()); }
  double bytes() const { return nodes() * static_cast<double>(bytes_of(engine.table())); }

  void tabulate() {
    for (std::size_t k = 0; k < slabs.size(); ++k)
      plan.tabulate(slabs[k], Polarization::unpolarized, buffers[k]);
    engine.queue().finish();
  }

  void store() {
    cl::Kernel kernel = engine.kernel("store_only");
    const std::size_t row = grid.phi_s.size() * bytes_of(engine.table()) / sizeof(float);
    for (std::size_t k = 0; k < slabs.size(); ++k) {
      set_arguments(kernel, buffers[k], static_cast<cl_int>(row), 0.5f);
      engine.run(kernel, {row, slabs[k].nodes() / grid.phi_s.size(), 1});
    }
    engine.queue().finish();
  }
};

Axis axis(AxisKind kind, double last, std::size_t nodes) {
  std::vector<double> angles(nodes);
  for (std::size_t k = 0; k < nodes; ++k)
    angles[k] = last * static_cast<double>(k) / static_cast<double>(nodes - 1);
  return Axis(kind, angles);
}

std::vector<DirectionPair> random_directions(std::size_t count) {
  std::mt19937_64 random(1);
  const auto below = [&](double limit) { return std::uniform_real_distribution(0.0, limit)(random); };
  std::vector<double> incidences(18);
  for (double& theta : incidences) theta = below(85);
  std::vector<DirectionPair> pairs(count);
  for (std::size_t k = 0; k < count; ++k)
    pairs[k] = {incidences[k % incidences.size()], below(89), below(360), 0};
  return pairs;
}

}  // namespace

std::vector<Workload> device_workloads(const Engine& engine, const Material& material,
                                       std::size_t table_bytes) {
  const Band& band = material.bands().front();
  const Variant& variant = material.variant();
  const std::size_t samples = table_bytes / bytes_of(engine.table());
  // theta_i, phi_i, theta_s, phi_s: 18 x 72 x 90 x as many as the size asks for; and as many without phi_i.
  const Grid four{axis(AxisKind::theta_i, 85, 18), axis(AxisKind::phi_i, 355, 72),
                  axis(AxisKind::theta_s, 89, 90),
                  axis(AxisKind::phi_s, 360, samples / (18 * 72 * 90) / 360 * 360 + 361)};
  const Grid three{axis(AxisKind::theta_i, 85, 171), Axis(AxisKind::phi_i, {0}),
                   axis(AxisKind::theta_s, 89.5, 180),
                   axis(AxisKind::phi_s, 360, samples / (171 * 180) / 360 * 360 + 361)};
  const auto dense = std::make_shared<DeviceTable>(engine, material, four);
  const auto rows = std::make_shared<DeviceTable>(engine, material, three);
  const auto host = std::make_shared<std::vector<std::byte>>(static_cast<std::size_t>(dense->bytes()));
  const auto pairs = std::make_shared<std::vector<DirectionPair>>(random_directions(listed_directions));
  const auto theta = std::make_shared<std::vector<double>>(91);
  for (std::size_t k = 0; k < theta->size(); ++k) (*theta)[k] = 0.5 * static_cast<double>(k);
  const auto n = std::make_shared<Normalizations>(normalizations(engine, band, variant, *theta));

  return {
      {"memset", "host memset of the dense table's bytes by all threads", "byte", dense->bytes(),
       dense->bytes(),
       [host] {
         const std::size_t count = hardware_threads();
         parallel_for(count, [&](std::size_t k) {
           const std::size_t begin = host->size() * k / count;
           std::memset(host->data() + begin, 1, host->size() * (k + 1) / count - begin);
         });
       }},
      {"store", "a kernel that stores constants over the dense table's buffers", "sample", dense->nodes(),
       dense->bytes(), [dense] { dense->store(); }},
      {"dense", "the factored path on a table of all four angles, in device memory", "sample", dense->nodes(),
       dense->bytes(), [dense] { dense->tabulate(); }},
      {"store rows", "a kernel that stores constants over the buffers of dense rows", "sample", rows->nodes(),
       rows->bytes(), [rows] { rows->store(); }},
      {"dense rows", "the factored path on a table of one phi_i, where no row repeats", "sample",
       rows->nodes(), rows->bytes(), [rows] { rows->tabulate(); }},
      {"direct",
       "f_s and f_p at a list of random directions of 18 incidences, lists and results in host memory",
       "direction", static_cast<double>(pairs->size()), 0,
       [&engine, &band, &variant, pairs] { evaluate(engine, band, variant, *pairs); }},
      {"N", "N of three lobes at 91 angles", "value", 3.0 * 91, 0,
       [&engine, &band, &variant, theta] { normalizations(engine, band, variant, *theta); }},
      {"N and DHR", "N and DHR of three lobes at 91 angles", "value", 3.0 * 91, 0,
       [&engine, &band, &variant, theta] { integrals(engine, band, variant, *theta); }},
  };
}

std::vector<Workload> reference_workloads(const Material& material) {
  const Band& band = material.bands().front();
  // A model for each thread: they would wait for each other's look-ups of N.
  const auto models = std::make_shared<std::vector<reference::Model>>();
  const auto pairs = std::make_shared<std::vector<DirectionPair>>(random_directions(reference_directions));
  for (std::size_t k = 0; k < hardware_threads(); ++k) {
    models->emplace_back(band.parameters, material.variant());
    // N is left out: a model keeps it from here on.
    for (const auto& pair : *pairs) models->back().brdf(pair.theta_i, pair.theta_s, pair.phi);
  }
  const auto evaluate_part = [models, pairs](std::size_t k, std::size_t count) {
    for (std::size_t j = k; j < pairs->size(); j += count)
      (*models)[k].brdf((*pairs)[j].theta_i, (*pairs)[j].theta_s, (*pairs)[j].phi);
  };
  return {
      {"reference", "the scalar reference's f_s and f_p at random directions on one thread, N known",
       "direction", static_cast<double>(pairs->size()), 0, [evaluate_part] { evaluate_part(0, 1); }},
      {"reference, all threads", "the same on all threads", "direction", static_cast<double>(pairs->size()),
       0,
       [evaluate_part] {
         const std::size_t count = hardware_threads();
         parallel_for(count, [&](std::size_t k) { evaluate_part(k, count); });
       }},
      {"reference N", "the scalar reference's N of three lobes at one angle on one thread", "value", 3, 0,
       [&band, &material] {
         const reference::Model fresh(band.parameters, material.variant());
         for (const Lobe lobe : {Lobe::surface, Lobe::bulk, Lobe::retro}) fresh.normalization(lobe, 45);
       }},
      {"reference N and DHR", "the scalar reference's N and DHR of three lobes at one angle on one thread",
       "value", 3, 0, [&band, &material] { reference::Model(band.parameters, material.variant()).dhr(45); }},
  };
}

}  // namespace brdftab

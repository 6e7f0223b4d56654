#include "host/table/generate.hpp"

#include <algorithm>
#include <chrono>
#include <mutex>
#include <optional>
#include <thread>

#include "host/base/error.hpp"
#include "host/base/partial_file.hpp"
#include "host/compute/plan.hpp"
#include "host/compute/rounding.hpp"
#include "host/table/chunk.hpp"
#include "host/table/slab_ring.hpp"
#include "host/table/validation/spot_check.hpp"

namespace brdftab {
namespace {

constexpr double most_samples = 1e13;

// A writer knows the partial file only; its user, the table's name.
template <class Work>
void naming(const std::filesystem::path& target, Work work) {
  try {
    work();
  } catch (const FileError& error) {
    throw FileError("{}: cannot be written: {}", target.string(), error.what());
  }
}

template <class Work>
double seconds(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

// Of a file, or of a folder of slices.
std::size_t stored_bytes(const std::filesystem::path& path) {
  if (!std::filesystem::is_directory(path)) return std::filesystem::file_size(path);
  std::size_t bytes = 0;
  for (const auto& slice : std::filesystem::directory_iterator(path)) bytes += slice.file_size();
  return bytes;
}

std::string description_of(std::span<const Engine* const> engines) {
  std::vector<std::string> descriptions;
  for (const Engine* engine : engines) descriptions.push_back(engine->device().description());
  return fmt::format("{}", fmt::join(descriptions, "; "));
}

}  // namespace

GenerateSummary generate(std::span<const Engine* const> engines, const Material& material,
                         const Grid& dense_grid, const std::filesystem::path& target,
                         const CreateTable& create, const GenerateOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Engine& engine = *engines.front();
  const std::size_t node_bytes = bytes_of(engine.table());
  const std::size_t datasets = material.bands().size() * options.polarizations.size();
  const long double wanted = static_cast<long double>(dense_grid.theta_i.size()) * dense_grid.phi_i.size() *
                             dense_grid.theta_s.size() * dense_grid.phi_s.size() * datasets;
  if (wanted > most_samples)
    throw BadInput("{}: the table would have {:.3g} samples: at most {:.0e} are allowed", target.string(),
                   static_cast<double>(wanted), most_samples);
  const auto dense = static_cast<std::size_t>(wanted);
  const Grid grid = stored_grid(dense_grid, options.storage);
  const std::size_t samples = grid.directions() * datasets;
  PartialFile file(target, options.force);
  // What compression leaves is not known before.
  if (options.storage.deflate_level == 0) file.require_space(samples * node_bytes);

  const TableContent content{.material = material,
                             .grid = grid,
                             .dense_grid = dense_grid,
                             .polarizations = options.polarizations,
                             .precision = engine.table(),
                             .working = engine.working(),
                             .storage = options.storage,
                             .device = description_of(engines),
                             .build_options = engine.build_options(),
                             .history = options.history,
                             .watch = engine.watch(),
                             .grid_choice = options.grid_choice};
  const Chunk chunk = options.storage.deflate_level > 0 ? chunk_shape(grid, node_bytes) : Chunk{};
  const auto cuts = slabs(grid, std::max<std::size_t>(options.slab_bytes / node_bytes, 1), chunk);
  const std::size_t largest = std::max_element(cuts.begin(), cuts.end(), [](const Slab& a, const Slab& b) {
                                return a.nodes() < b.nodes();
                              })->nodes();
  TableFindings findings;
  StageSeconds stages;
  SpotCheck spot_check(content);
  std::unique_ptr<TableWriter> writer;
  naming(target, [&] { writer = create(file.path(), content); });
  {
    const std::size_t band_slabs = cuts.size() * options.polarizations.size();
    SlabRing ring(engines, material.bands().size() * band_slabs, largest * node_bytes);
    std::mutex checking;
    std::size_t done = 0;
    const auto report_progress = [&](std::size_t more) {
      done += more;
      if (const auto& report = engine.watch().progress)
        report({target.filename().string(), done, samples, node_bytes});
    };
    report_progress(0);
    for (std::size_t band = 0; band < material.bands().size(); ++band) {
      const Band& this_band = material.bands()[band];
      Integrals band_integrals;
      stages.plan += seconds(
          [&] { band_integrals = integrals(engine, this_band, material.variant(), grid.theta_i.nodes()); });
      const auto tabulate_on = [&](const Engine& device) {
        StageSeconds spent;
        std::optional<Plan> plan;
        spent.plan = seconds([&] { plan.emplace(device, material, this_band, grid, band_integrals); });
        while (const auto turn = ring.take(device, (band + 1) * band_slabs)) {
          engine.watch().stop_if_asked();
          const std::size_t polarization = turn->slab % band_slabs / cuts.size();
          const Slab& slab = cuts[turn->slab % cuts.size()];
          spent.compute += seconds([&] {
            plan->tabulate(slab, options.polarizations[polarization], turn->samples);
            if (options.storage.keep_bits)
              round_mantissas(device, slab, turn->samples, *options.storage.keep_bits);
            device.queue().finish();
          });
          std::span<const std::byte> mapped;
          spent.transfer += seconds([&] { mapped = ring.map(*turn, slab.nodes() * node_bytes); });
          plan->check(slab, mapped);
          {
            const std::lock_guard lock(checking);
            spot_check.take(polarization, band, slab, mapped);
            report_progress(slab.nodes());
          }
          ring.submit(*turn, [&, polarization, band, slab](std::span<const std::byte> bytes) {
            stages.write +=
                seconds([&] { naming(target, [&] { writer->write(polarization, band, slab, bytes); }); });
          });
        }
        const std::lock_guard lock(checking);
        stages.plan += spent.plan;
        stages.compute += spent.compute;
        stages.transfer += spent.transfer;
      };
      {
        std::vector<std::jthread> threads;
        for (const Engine* device : engines)
          threads.emplace_back([&, device] {
            try {
              tabulate_on(*device);
            } catch (...) {
              ring.fail();
            }
          });
        findings.reciprocity.push_back(reciprocity(this_band, material.variant()));
      }
      ring.rethrow();
      for (auto& warning : energy_warnings(material, this_band, grid.theta_i.nodes(), band_integrals.dhr,
                                           options.polarizations))
        findings.energy_warnings.push_back(std::move(warning));
      findings.integrals.push_back(band_integrals);
    }
    ring.drain();
  }
  findings.accuracy = spot_check.compare();
  // Devices without fp64 promise nothing at a node; but what is nowhere near is no table.
  constexpr double believable_float32 = 1e-2;
  double promised =
      engine.working() == Precision::float64 ? promised_error(engine.table()) : believable_float32;
  if (options.storage.keep_bits) promised += (1 + promised) * rounding_error(*options.storage.keep_bits);
  if (!(findings.accuracy.max_relative_error <= promised))
    throw Error(Fault::check,
                "{}: not written: a sample differs from the scalar reference by {:.1e}, more than {:.0e}; "
                "the device or its driver is at fault",
                target.string(), findings.accuracy.max_relative_error, promised);
  engine.watch().stop_if_asked();
  naming(target, [&] { writer->finish(findings); });
  const std::size_t file_bytes = stored_bytes(file.path());
  file.commit();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return {dense, dense * node_bytes, file_bytes, elapsed.count(), stages, std::move(findings)};
}

}  // namespace brdftab

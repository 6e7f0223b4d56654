#include "host/generate.hpp"

#include <algorithm>
#include <chrono>

#include "host/error.hpp"
#include "host/interrupt.hpp"
#include "host/partial_file.hpp"
#include "host/plan.hpp"
#include "host/progress.hpp"
#include "host/slab_ring.hpp"
#include "host/spot_check.hpp"

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

}  // namespace

GenerateSummary generate(const Engine& engine, const Material& material, const Grid& grid, const std::filesystem::path& target,
                         const CreateTable& create, const GenerateOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const std::size_t node_bytes = bytes_of(engine.table());
  const long double wanted = static_cast<long double>(grid.theta_i.size()) * grid.phi_i.size() * grid.theta_s.size() *
                             grid.phi_s.size() * material.bands().size() * options.polarizations.size();
  if (wanted > most_samples)
    throw BadInput("{}: the table would have {:.3g} samples: at most {:.0e} are allowed", target.string(),
                   static_cast<double>(wanted), most_samples);
  const auto samples = static_cast<std::size_t>(wanted);
  PartialFile file(target, options.force);
  file.require_space(samples * node_bytes);

  const TableContent content{.material = material,
                             .grid = grid,
                             .polarizations = options.polarizations,
                             .precision = engine.table(),
                             .working = engine.working(),
                             .device = engine.device().description(),
                             .build_options = engine.build_options(),
                             .history = options.history,
                             .grid_choice = options.grid_choice};
  const auto cuts = slabs(grid, std::max<std::size_t>(options.slab_bytes / node_bytes, 1));
  const std::size_t largest =
      std::max_element(cuts.begin(), cuts.end(), [](const Slab& a, const Slab& b) { return a.nodes() < b.nodes(); })->nodes();
  TableFindings findings;
  SpotCheck spot_check(content);
  std::unique_ptr<TableWriter> writer;
  naming(target, [&] { writer = create(file.path(), content); });
  Progress progress(target.filename().string(), samples, node_bytes, options.quiet);
  std::size_t done = 0;
  {
    SlabRing ring(engine, largest * node_bytes);
    for (std::size_t band = 0; band < material.bands().size(); ++band) {
      Plan plan(engine, material, material.bands()[band], grid);
      for (std::size_t polarization = 0; polarization < options.polarizations.size(); ++polarization)
        for (const Slab& slab : cuts) {
          stop_if_interrupted();
          plan.tabulate(slab, options.polarizations[polarization], ring.acquire());
          const auto mapped = ring.map(slab.nodes() * node_bytes);
          plan.check(slab, mapped);
          spot_check.take(polarization, band, slab, mapped);
          ring.submit([&, polarization, band, slab](std::span<const std::byte> bytes) {
            naming(target, [&] { writer->write(polarization, band, slab, bytes); });
          });
          done += slab.nodes();
          progress.report(done);
        }
      const Band& this_band = material.bands()[band];
      for (auto& warning :
           energy_warnings(material, this_band, grid.theta_i.nodes(), plan.integrals().dhr, options.polarizations))
        findings.energy_warnings.push_back(std::move(warning));
      findings.integrals.push_back(plan.integrals());
      findings.reciprocity.push_back(reciprocity(engine, this_band, material.switches()));
    }
    ring.drain();
  }
  findings.accuracy = spot_check.compare();
  const double promised = promised_error(engine.table());
  if (engine.working() == Precision::float64 && !(findings.accuracy.max_relative_error <= promised))
    throw Error(ExitStatus::check_failed,
                "{}: not written: a sample differs from the scalar reference by {:.1e}, more than {:.0e}; the device or its "
                "driver is at fault",
                target.string(), findings.accuracy.max_relative_error, promised);
  stop_if_interrupted();
  naming(target, [&] { writer->finish(findings); });
  file.commit();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  return {samples, samples * node_bytes, elapsed.count(), std::move(findings)};
}

}  // namespace brdftab

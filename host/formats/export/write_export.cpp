#include "host/formats/export/write_export.hpp"

#include <chrono>

#include "host/base/error.hpp"
#include "host/base/partial_file.hpp"
#include "host/formats/export/export_errors.hpp"
#include "host/formats/export/export_model.hpp"

namespace brdftab {
namespace {

// These files are made whole in memory, about 150 bytes a sample.
constexpr std::size_t most_samples = 20'000'000;

}  // namespace

void check_holds(const ExportFormat& format, const Material& material, const Grid& grid) {
  const FormatTraits& traits = format.traits();
  if (!traits.holds_bands && material.bands().size() > 1)
    throw BadInput("has {} bands, and {} holds one: `wavelength` chooses it", material.bands().size(),
                   traits.name);
  const std::size_t samples = grid.directions() * material.bands().size();
  if (traits.takes_axes && samples > most_samples)
    throw BadInput("the axes have {} samples, and {} takes at most {}: coarser axes, `wavelength`, or hdf5",
                   samples, traits.name, most_samples);
}

ExportSummary write_export(const ExportFormat& format, const ExportModel& source,
                           const std::filesystem::path& target, bool force, bool with_errors) {
  const auto start = std::chrono::steady_clock::now();
  PartialFile file(target, force);
  ExportSummary summary;
  summary.notes = format.write(file.path(), source);
  const auto table = format.read(file.path());
  if (with_errors) {
    const ReadExport read = read_export(*table, source, export_directions(*table, default_directions));
    summary.errors = brdftab::summary(export_errors(read, source), format, *table);
  }
  summary.bytes = std::filesystem::file_size(file.path());
  file.commit();
  summary.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return summary;
}

}  // namespace brdftab

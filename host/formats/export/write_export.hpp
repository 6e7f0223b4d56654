// A simulator's file, written under its name once it is complete, and what its consumer will get from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "host/formats/format.hpp"
#include "host/model/material.hpp"

namespace brdftab {

/// Throws BadInput where the format holds one band and the material has several, or where the axes have more
/// samples than memory takes.
void check_holds(const ExportFormat& format, const Material& material, const Grid& grid);

struct ExportSummary {
  std::uintmax_t bytes = 0;
  double seconds = 0;
  /// What had to be changed, one line each.
  std::vector<std::string> notes;
  /// The consumer's errors of f, in one line; empty where they were not asked for.
  std::string errors;
};

/// Writes the file and reads it back. Without `force` it never overwrites one. Throws as ExportFormat::write
/// does, and FileError.
ExportSummary write_export(const ExportFormat& format, const ExportModel& source,
                           const std::filesystem::path& target, bool force, bool with_errors);

}  // namespace brdftab

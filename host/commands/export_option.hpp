// The simulators' formats of `generate`, their options, and the writing of their files.
#pragma once

#include "host/commands/command.hpp"
#include "host/commands/outputs.hpp"
#include "host/formats/format.hpp"

namespace brdftab {

class ExportOption {
 public:
  ExportOption() : formats_(export_formats()) {}

  const ExportFormats& formats() const { return formats_; }

  /// Adds each format's options in a group of its own, and those that all share.
  void add(CLI::App& parser);

  /// Throws BadInput where an option was given that does not go with the format; null: a dense table.
  void check(const CLI::App& parser, const ExportFormat* chosen) const;

  /// The material, or the one band of it that was asked for. Throws BadInput where the format does not hold
  /// its bands, or so many samples.
  Material material_for(const ExportFormat& format, const MaterialOutput& output, const Grid& grid) const;

  /// Writes a material's file, and says what its consumer will get from it.
  void write(const Engine& engine, const ExportFormat& format, const Material& material, const Grid& grid,
             const std::filesystem::path& target, const std::string& history, bool force,
             const CommonOptions& common) const;

 private:
  ExportFormats formats_;
  std::optional<double> wavelength_nm_;
  std::string illuminant_ = std::string(illuminant_names.front());
};

/// Groups of generate's options, by what they go with.
inline constexpr const char* axes_group = "Axes";
inline constexpr const char* dense_group = "Dense tables (hdf5, exr)";

}  // namespace brdftab

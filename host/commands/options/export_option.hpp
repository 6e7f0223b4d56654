// What `generate` offers for all simulators' formats alike, and the writing of their files.
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

#include "host/commands/outputs.hpp"
#include "host/formats/format.hpp"
#include "host/model/colorimetry.hpp"

namespace brdftab {

class ExportOption {
 public:
  /// --wavelength and --illuminant.
  void add(CLI::App& parser);

  /// Throws BadInput where an option was given that does not go with formats of the chosen kind.
  void check(const CLI::App& parser, const Format& chosen) const;

  /// The material, or the one band of it that was asked for. Throws BadInput where the format does not hold
  /// its bands, or so many samples.
  Material material_for(const ExportFormat& format, const MaterialOutput& output, const Grid& grid) const;

  Illuminant illuminant() const;

 private:
  std::optional<double> wavelength_nm_;
  std::string illuminant_ = std::string(illuminant_names.front());
};

/// Groups of generate's options, by what they go with.
inline constexpr const char* axes_group = "Axes";
inline constexpr const char* dense_group = "Dense tables (hdf5, exr)";

}  // namespace brdftab

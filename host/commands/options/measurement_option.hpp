// The options that say how a measured file is read, of every command that reads one.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

#include "host/model/measurement/measurement.hpp"

namespace brdftab {

/// --format, --angles, --values, --scale, --wavelength-unit, --incidence-width, --flip-azimuth.
class MeasurementOption {
 public:
  void add(CLI::App& parser);

  /// As given.
  MeasurementOptions options() const;
  /// The names of the options that were given.
  std::vector<std::string> given() const;

 private:
  MeasurementOptions options_;
  std::string angles_, values_, wavelength_unit_;
  std::vector<const CLI::Option*> all_;
};

}  // namespace brdftab

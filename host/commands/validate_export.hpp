// `validate` for files of simulators' formats.
#pragma once

#include "host/commands/command.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/registry.hpp"

namespace brdftab {

class ExportValidation {
 public:
  ExportValidation() : formats_(all_formats()) {}

  void add(CLI::App& parser);

  /// The format of a file that is one of theirs; null: it is none. Throws FileError where it cannot be read.
  const ExportFormat* format_of(const std::string& file) const;

  struct Request {
    std::string file;
    std::optional<std::size_t> directions;
    std::optional<double> tolerance;
    std::optional<std::string> device;
    bool json = false;
  };
  /// Reports the error of the consumer's own interpolation. Throws Error (exit status 1) where it is beyond
  /// what the format reaches by more than the tolerance.
  ExitStatus run(const ExportFormat& format, const Request& request, const Watch& watch) const;

 private:
  ExportModel source(const Engine& engine, const ExportReader& table, const Request& request) const;

  Formats formats_;
  std::optional<std::string> material_;
  std::optional<double> wavelength_nm_;
  std::optional<std::string> illuminant_;
};

}  // namespace brdftab

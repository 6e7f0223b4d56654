// A file format is one object, made in a source file of its own, and a row of the registry.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/format_option.hpp"
#include "host/formats/measurement_reader.hpp"
#include "host/table/table_storage.hpp"

namespace brdftab {

class ExportModel;
class ExportReader;
class TableReader;
class TableWriter;
struct TableContent;

struct FormatTraits {
  /// Users call it so.
  std::string_view name;
  /// Says who reads it, for help.
  std::string_view consumer = {};
  /// File names with these endings are this format's alone, and so tell it where a file is written.
  std::vector<std::string_view> extensions = {};
  /// In a folder this follows the material's name: "_zemax.bsdf".
  std::string_view suffix = {};
  /// Its nodes are those of the axes that the user gives; otherwise it has a grid of its own.
  bool takes_axes = false;
  /// It can hold several bands, as bands or as a colour; otherwise one is chosen.
  bool holds_bands = true;
  bool holds_polarization = false;
  /// It tells f(i, s) from f(s, i).
  bool holds_non_reciprocal = true;
  /// It is set where the format's files are read as measurements.
  std::optional<MeasurementReader> measurement = {};
};

class DenseFormat;
class ExportFormat;

class Format {
 public:
  explicit Format(FormatTraits traits) : traits_(std::move(traits)) {}
  virtual ~Format() = default;

  const FormatTraits& traits() const { return traits_; }

  /// The format's own settings. They point into this object.
  virtual std::vector<FormatOption> options() { return {}; }

  /// Says whether a file that begins so (4096 bytes or all of it; nothing of a folder) is of this format.
  virtual bool recognises(const std::filesystem::path& file, std::string_view beginning) const {
    static_cast<void>(file), static_cast<void>(beginning);
    return false;
  }

  /// Give what writes and reads the format; null where it is of the other kind, or a measurement's alone.
  virtual const DenseFormat* as_dense() const { return nullptr; }
  virtual const ExportFormat* as_export() const { return nullptr; }

 private:
  FormatTraits traits_;
};

/// A format of tables of this program, which are computed and written slab by slab.
class DenseFormat : public Format {
 public:
  using Format::Format;
  const DenseFormat* as_dense() const final { return this; }

  /// Says how the samples lie in a file, as far as the options of the format tell.
  virtual TableStorage storage() const { return {}; }
  /// Says whether the writer puts a folder in the place of the file.
  virtual bool writes_folder() const { return false; }

  /// Creates the file over an existing empty one. Throws BadInput for what the format cannot hold, FileError.
  virtual std::unique_ptr<TableWriter> create(const std::filesystem::path& file,
                                              const TableContent& content) const = 0;
  /// Opens a table. Throws FileError where the file cannot be read, and BadInput where it is no table of this
  /// program.
  virtual std::unique_ptr<TableReader> open(const std::filesystem::path& file) const = 0;
};

/// A format that simulators load, written whole from f at whatever directions it needs.
class ExportFormat : public Format {
 public:
  using Format::Format;
  const ExportFormat* as_export() const final { return this; }

  /// Writes the file, which is renamed by the caller when it is complete. Returns notes for the user, one
  /// line each: what had to be changed, with its number. Throws BadInput where the material or an option does
  /// not suit the format.
  virtual std::vector<std::string> write(const std::filesystem::path& file,
                                         const ExportModel& source) const = 0;

  /// Reads a file. Throws FileError where it cannot be read, and BadInput with FILE:LINE or the field where
  /// it is not of this format.
  virtual std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const = 0;
};

}  // namespace brdftab

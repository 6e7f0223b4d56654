// Files that simulators load: one object a format, one source file a format in host/formats.
#pragma once

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/export/export_model.hpp"
#include "host/formats/export/export_values.hpp"

namespace brdftab {

/// What a value of a format is: f of one band, or of a colour.
enum class ExportChannels { bands, xyz, rgb };

/// A file read back, and interpolated as its consumer does.
class ExportReader {
 public:
  virtual ~ExportReader() = default;

  /// f in 1/sr as the consumer gets it, [channel][direction]; directions are the model's.
  virtual std::vector<std::vector<double>> evaluate(const Directions& directions) const = 0;

  virtual ExportChannels channels() const { return ExportChannels::bands; }
  /// Of colours, as the file says; D65 where it cannot.
  virtual Illuminant illuminant() const { return Illuminant::d65; }
  /// Of the bands that the file holds, where it says so.
  virtual std::vector<double> wavelengths_nm() const { return {}; }
  /// The material's TOML text; empty where the format cannot hold it.
  virtual std::string material_text() const { return {}; }
  /// How the consumer interpolates, in words.
  virtual std::string interpolation() const = 0;

  /// Where the file has samples, degrees; phi is the model's, and a whole turn also where f's evenness makes
  /// it one.
  virtual AngleRange theta_i_range() const { return {0, 90}; }
  virtual AngleRange theta_s_range() const { return {0, 90}; }
  virtual AngleRange phi_range() const { return {-180, 180}; }
  /// Whether it has samples at a pair of directions within these ranges.
  virtual bool covers(const Directions& directions, std::size_t k) const {
    static_cast<void>(directions), static_cast<void>(k);
    return true;
  }

  /// The file as it should be: with its own nodes or cells, digits and conventions, but f of the source as
  /// its values. Every value of the file is compared with the one that it should be. Throws BadInput where
  /// the channels are not the source's.
  virtual std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const = 0;
};

/// [channel][direction] from the source's f, [band][direction].
std::vector<std::vector<double>> in_channels(ExportChannels channels, const ExportModel& source,
                                             const std::vector<std::vector<double>>& by_band);

/// Throws BadInput where a file has another number of channels than its material gives.
void check_channels(std::size_t file, std::size_t material);

/// What a channel is called, for messages: "R", "X", "550 nm"; "f" where it has no name.
std::string channel_name(ExportChannels channels, const ExportModel& source, std::size_t channel);

/// "theta_i = 30, theta_s = 40, phi = -20 degrees", for messages.
std::string angles_text(const Directions& directions, std::size_t k);

struct FormatTraits {
  /// As --format takes it.
  std::string_view name;
  /// Who reads it, for --help.
  std::string_view consumer;
  /// Those that are this format's alone, and so tell the format.
  std::vector<std::string_view> extensions;
  /// Of a file in a folder, after the material's name: "_zemax.bsdf".
  std::string_view suffix;
  /// Its nodes are --theta-i, --phi-i, --theta-s and --phi-s; otherwise it has a grid of its own.
  bool takes_axes = false;
  /// It can hold several bands, as bands or as a colour; otherwise --wavelength chooses one.
  bool holds_bands = true;
  bool holds_polarization = false;
  /// It tells f(i, s) from f(s, i).
  bool holds_non_reciprocal = true;
};

class ExportFormat {
 public:
  explicit ExportFormat(FormatTraits traits) : traits_(std::move(traits)) {}
  virtual ~ExportFormat() = default;

  const FormatTraits& traits() const { return traits_; }

  /// Adds the format's own options, each named --NAME-...; the caller has them in one group of the help.
  virtual void add_options(CLI::App& parser) { static_cast<void>(parser); }

  /// Those of them that a reader needs, where the file does not say.
  virtual void add_reading_options(CLI::App& parser) { static_cast<void>(parser); }

  /// Writes the file, which is renamed by the caller when it is complete. Returns notes for the user, one
  /// line each: what had to be changed, with its number. Throws BadInput where the material or an option does
  /// not suit the format.
  virtual std::vector<std::string> write(const std::filesystem::path& file,
                                         const ExportModel& source) const = 0;

  /// Whether a file that begins so (4096 bytes or all of it) is of this format.
  virtual bool recognises(const std::filesystem::path& file, std::string_view beginning) const = 0;

  /// Throws FileError where it cannot be read, and BadInput with FILE:LINE or the field where it is not of
  /// this format.
  virtual std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const = 0;

 private:
  FormatTraits traits_;
};

using ExportFormats = std::vector<std::unique_ptr<ExportFormat>>;

/// All of them, with default options, in the order of their names.
ExportFormats export_formats();

/// The format that recognises a file's beginning; null where none does. Throws FileError where the file
/// cannot be read.
const ExportFormat* recognised_format(const ExportFormats& formats, const std::filesystem::path& file);

/// Reads a material's file; one of a simulator is refused by its format's name. Throws as Material::read
/// does.
Material read_material_file(const std::filesystem::path& file);

}  // namespace brdftab

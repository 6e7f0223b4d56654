// A simulator's file read back, and interpolated as its consumer does.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "host/formats/export/export_model.hpp"
#include "host/formats/export/export_values.hpp"

namespace brdftab {

/// What a value of a file is: f of one band, or of a colour.
enum class ExportChannels { bands, xyz, rgb };

class ExportReader {
 public:
  virtual ~ExportReader() = default;

  /// Gives f in 1/sr as the consumer gets it, [channel][direction]; directions are the model's.
  virtual std::vector<std::vector<double>> evaluate(const Directions& directions) const = 0;

  virtual ExportChannels channels() const { return ExportChannels::bands; }
  /// The illuminant of colours, where the file says it; otherwise D65.
  virtual Illuminant illuminant() const { return Illuminant::d65; }
  /// The wavelengths of the bands that the file holds, where it says them.
  virtual std::vector<double> wavelengths_nm() const { return {}; }
  /// The material's TOML text; empty where the format cannot hold it.
  virtual std::string material_text() const { return {}; }
  /// Says in words how the consumer interpolates.
  virtual std::string interpolation() const = 0;

  /// The ranges where the file has samples, degrees; phi is the model's, and its range is a whole turn also
  /// where f's evenness makes it one.
  virtual AngleRange theta_i_range() const { return {0, 90}; }
  virtual AngleRange theta_s_range() const { return {0, 90}; }
  virtual AngleRange phi_range() const { return {-180, 180}; }
  /// Says whether it has samples at a pair of directions within these ranges.
  virtual bool covers(const Directions& directions, std::size_t k) const {
    static_cast<void>(directions), static_cast<void>(k);
    return true;
  }

  /// Makes the file as it should be: it has the file's nodes or cells, digits and conventions, but f of the
  /// source as its values. Every value of the file is compared with the one that it should be. Throws
  /// BadInput where the channels are not the source's.
  virtual std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const = 0;
};

/// Makes [channel][direction] of the source's f, [band][direction].
std::vector<std::vector<double>> in_channels(ExportChannels channels, const ExportModel& source,
                                             const std::vector<std::vector<double>>& by_band);

/// Throws BadInput where a file has another number of channels than its material gives.
void check_channels(std::size_t file, std::size_t material);

/// Says what a channel is called, for messages: "R", "X", "550 nm"; "f" where it has no name.
std::string channel_name(ExportChannels channels, const ExportModel& source, std::size_t channel);

/// Writes "theta_i = 30, theta_s = 40, phi = -20 degrees", for messages.
std::string angles_text(const Directions& directions, std::size_t k);

}  // namespace brdftab

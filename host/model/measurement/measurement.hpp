// A measured BRDF: what a file holds, cleaned and counted, before any model is fitted to it.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/model/direction_list.hpp"
#include "host/model/measurement/angle_unit.hpp"
#include "host/model/measurement/incidences.hpp"
#include "host/model/measurement/value_kind.hpp"
#include "host/model/measurement/wavelength_unit.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// A sample is f_r in 1/sr at a pair of directions, not weighted by a cosine.
struct MeasuredSample {
  DirectionPair pair;
  double brdf;
  /// The standard uncertainty of f in 1/sr; nan where the file gives none.
  double sigma = std::numeric_limits<double>::quiet_NaN();
  /// The index into Measurement::channels.
  std::size_t channel = 0;
  /// The share of s-polarised light; 1/2 is unpolarised.
  double share_s = 0.5;
};

struct Measurement {
  std::string source;
  /// Wavelengths in nm or names, in the order of the file; one empty name where it has no channels.
  std::vector<std::string> channels;
  std::vector<MeasuredSample> samples;
  /// What was set aside or looks suspicious, one line each, with counts.
  std::vector<std::string> warnings;
  /// How the samples were taken, where the file does not say it.
  std::vector<std::string> notes = {};
  /// Angles of incidence within this width are one setting, degrees.
  double incidence_width = Incidences::usual_width;
  /// Each value is the mean of f(i, s) and f(s, i), as in formats that cannot tell the two apart.
  bool mean_of_exchanges = false;

  bool has_sigma() const;
  /// Gives the settings of theta_i, of all channels together.
  Incidences incidences() const;
  /// Gives a channel's wavelength; none where its name is no wavelength.
  std::optional<double> wavelength_nm(std::size_t channel) const;
  /// Finds a channel by its text, or by its wavelength in whatever text and unit.
  std::optional<std::size_t> find_channel(std::string_view name) const;
  /// Gives the samples of one channel, as a measurement of its own.
  Measurement channel(std::size_t index) const;
};

/// What the user says about a file's conventions.
struct MeasurementOptions {
  /// The name of a format that is read as a measurement; empty: the file's extension tells it.
  std::string format = {};
  /// The unit of the angles; none: the layout's own (csv and zemax: degrees, alta and astm: radians).
  std::optional<AngleUnit> angles = {};
  /// What the values are; none: f in 1/sr, and a warning where they look unlike it.
  std::optional<ValueKind> values = {};
  /// A further factor to f in 1/sr, beside `values`.
  double scale = 1;
  /// The unit of wavelengths whose text or column names none; none: nm, and a warning where that is no
  /// light's.
  std::optional<WavelengthUnit> wavelength_unit = {};
  /// The number of directions over the hemisphere that a MERL file is sampled at; 0: in plane.
  std::size_t merl_samples = 0;
  std::uint64_t merl_seed = 1;
  /// Adds 180 degrees to phi, for files whose azimuth 0 is the backward side.
  bool flip_azimuth = false;
  /// Chooses what is read: the columns brdf, brdf_s or brdf_p of CSV, or s and p together. Of other formats
  /// it says what light they were measured in.
  std::vector<Polarization> light{Polarization::unpolarized};
  /// Angles of incidence within this width are one setting, degrees; 0 tells every two numbers apart.
  double incidence_width = Incidences::usual_width;
};

/// Channels that are the same wavelength, whatever their text, become one; names with another unit than nm,
/// or in `unit`, become numbers in nm.
void unite_channels(Measurement& measurement, const std::optional<WavelengthUnit>& unit);

/// For formats that grids are written in: where every direction that occurs again has its value again, all
/// but the first are set aside and counted. Where one does not, the rows are readings, and all are kept.
void set_aside_repeats_of_grid(Measurement& measurement);

/// Sets aside what is no number; then counts readings that are not above 0 or repeat, and adds warnings where
/// values or azimuths look unlike f_r in 1/sr with phi = 0 forward. Throws BadInput where no value is above
/// 0.
void clean(Measurement& measurement, const MeasurementOptions& options = {});

}  // namespace brdftab

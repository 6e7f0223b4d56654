// What a consumer gets from a simulator's file, against the model: the error of its own interpolation at
// random directions, and what the format cannot hold, in numbers.
#pragma once

#include <string>
#include <vector>

#include "host/formats/export/export_directions.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/format.hpp"

namespace brdftab {

/// At the same directions, f as a file's consumer reads it and f of the model, both [channel][direction].
struct ReadValues {
  Directions directions;
  std::vector<std::vector<double>> read, model;
};

/// The values at each kind of direction.
struct ReadExport {
  ReadValues uniform, near_mirror, near_retro;
};

/// Throws BadInput where the table's channels are not the source's.
ReadExport read_export(const ExportReader& table, const ExportModel& source,
                       const ExportDirections& directions);

/// How |f_consumer - f| / max(f, error_floor) is distributed over directions and channels.
struct ConsumerError {
  std::size_t values = 0;
  double median = 0;
  double percentile_95 = 0;
  double maximum = 0;
  // Where the maximum lies, in degrees, and both values of f there, in 1/sr.
  double theta_i = 0, theta_s = 0, phi = 0;
  std::size_t channel = 0;
  double consumer = 0;
  double model = 0;
};

struct ExportErrors {
  /// These are at pairs of directions uniform in solid angle, up to the file's largest angles.
  ConsumerError uniform;
  /// These are within 0.001 to 30 degrees of the mirror direction and of the retro-reflected one.
  ConsumerError near_peaks;
  /// What the model has at the uniform directions, and a format may be unable to hold.
  double reciprocity_median = 0, reciprocity_maximum = 0;  // |ln f(i, s)/f(s, i)|, each at least error_floor
  double polarization_median = 0, polarization_maximum = 0;  // |f_s - f_p| / (f_s + f_p)
};

ExportErrors export_errors(const ReadExport& read, const ExportModel& source);

/// As many uniform directions as this are drawn, and as many about the peaks, where the user does not say.
inline constexpr std::size_t default_directions = 10'000;

/// Says the errors in one line, with what the format loses.
std::string summary(const ExportErrors& errors, const ExportFormat& format, const ExportReader& table);

}  // namespace brdftab

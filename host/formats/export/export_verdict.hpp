// Whether a simulator's file is as good as its format at its resolution can be for its material.
//
// What the format reaches is measured: the file is rebuilt with its own nodes or cells, digits and
// conventions, but the model's values, and both are read at the same directions by the interpolation of the
// file's consumer.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/export/export_errors.hpp"

namespace brdftab {

/// A file may be off by this share of f beyond what its format reaches at its resolution: in the median, at
/// 95 % of directions and in the mean of each region, and in each value.
///
/// Formats hold seven digits or more, or as many as the file shows, and f is computed to 1e-11 of it, in
/// float32 arithmetic to 1e-5: what is right stays within a hundredth of this.
inline constexpr double default_export_tolerance = 1e-3;

/// The names of what is judged in a region, in the order of RegionErrors::statistics.
inline constexpr std::array<std::string_view, 3> statistic_names{"median", "95 %", "mean"};

/// Median and 95th percentile are of |f read - f| / max(f, error_floor). The mean is signed: the sum of f
/// read - f over the region's directions for the sum of max(f, error_floor); of directions uniform in solid
/// angle, without a cosine.
struct RegionStatistic {
  double file = 0;
  double reached = 0;  // by the rebuilt file
  double allowed = 0;  // reached and the tolerance; of a mean, on the file's side of 0
  double excess() const;
};

struct RegionErrors {
  std::string name;  // "theta_s 30 to 60 degrees"
  std::string channel;
  std::size_t directions = 0;
  std::array<RegionStatistic, 3> statistics;

  /// Gives the index of the statistic with the largest excess.
  std::size_t worst() const;
};

struct ExportVerdict {
  double tolerance;
  /// Every region that has directions is here, for every channel; the whole range comes first.
  std::vector<RegionErrors> regions;
  ValueErrors values;

  bool good() const;
  /// Names the region, statistic or value that is off most; empty where the file is good.
  std::string fault() const;
  /// Gives one region of each name: the channel whose worst statistic is off most.
  std::vector<RegionErrors> worst_channels() const;
};

/// Throws BadInput where the file's channels or wavelengths are not the source's.
ExportVerdict export_verdict(const ExportReader& table, const ExportModel& source, const ReadExport& read,
                             double tolerance);

}  // namespace brdftab

// What a fit says about itself in the material file that it writes: [fit], the intervals of the parameters in
// [fit.NAME], and those of a band's own parameters in [band.fit.NAME].
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "host/model/parameters.hpp"

namespace brdftab {

struct FitRange {
  double low, high;
};

/// What a fit says about one parameter, in the paper's units.
struct FittedParameter {
  /// The interval. None where the value is at a bound and a standard error says nothing of it.
  std::optional<FitRange> interval;
  /// The data do not limit the interval on this side: it ends at the bound, and the whole way to there fits
  /// about as well.
  bool open_below = false, open_above = false;
  /// The value itself ended at a bound.
  bool at_bound = false;
  /// Between which the fit searched.
  std::optional<FitRange> bounds;

  /// Whether the data limit the interval on both sides.
  bool is_closed() const { return interval && !open_below && !open_above; }
};

/// In the order of parameter_table; none where a parameter was not fitted.
using FittedParameters = std::array<std::optional<FittedParameter>, parameter_table.size()>;

/// How well the fit agrees at one setting of theta_i or at neighbouring ones together, angles in degrees.
struct FittedIncidence {
  double theta_i;
  /// The settings together; none where it is one.
  std::optional<FitRange> settings;
  std::size_t samples;
  /// Of the residuals.
  double rms;
  /// Of the fitted material at theta_i.
  double dhr;
};

struct FitRecord {
  std::string command, data, channel, light;
  std::optional<std::size_t> samples;
  std::optional<FitRange> theta_i, theta_s, brdf;
  std::optional<double> max_theta;
  std::optional<std::size_t> beyond_max_theta;
  std::optional<double> floor;
  std::optional<std::size_t> below_floor;
  std::string residuals, weights, loss;
  std::optional<double> noise_relative, noise_floor;
  std::vector<std::string> noise_estimated;
  std::optional<double> rms, rms_by_incidence;
  std::optional<std::size_t> rms_samples;
  std::optional<double> reduced_chi_square;
  std::optional<std::size_t> degrees_of_freedom;
  std::optional<std::size_t> starts, converged, reached;
  bool is_descending = false;
  std::optional<double> condition;
  std::string intervals;
  std::optional<double> level;
  std::vector<std::string> fixed, warnings;
  std::vector<FittedIncidence> incidences;
  /// Of [fit.NAME].
  FittedParameters parameters;
  /// Of [band.fit.NAME], for each band of the material.
  std::vector<FittedParameters> bands;

  /// What a band has not of its own is that of [fit].
  FittedParameters at_band(std::size_t band) const;
};

/// A key of [fit] that holds one value or a list of texts. Its member is empty, or false, where the file has
/// it not.
struct FitKey {
  using Member = std::variant<std::string FitRecord::*, bool FitRecord::*, std::optional<double> FitRecord::*,
                              std::optional<std::size_t> FitRecord::*, std::optional<FitRange> FitRecord::*,
                              std::vector<std::string> FitRecord::*>;
  std::string_view name;
  Member member;
  std::string_view meaning;
  /// Of texts; none: any line of text.
  std::vector<std::string_view> choices = {};
  /// Of numbers and of the ends of ranges.
  double minimum = 0, maximum = 1e300;
};

/// In the order in which a file has them.
const std::vector<FitKey>& fit_keys();

/// "95 %: 0.69 to 0.76; bounds 0.05 to 20; no lower limit", as people read it.
std::string text_of(const FittedParameter& fitted, double level);

}  // namespace brdftab

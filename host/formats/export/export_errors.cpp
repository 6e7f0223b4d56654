#include "host/formats/export/export_errors.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/statistics.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

using Channels = std::vector<std::vector<double>>;

ReadValues read_values(const ExportReader& table, const ExportModel& source, const Directions& directions) {
  ReadValues result{directions, table.evaluate(directions), {}};
  if (directions.size() > 0)
    result.model = in_channels(table.channels(), source, source.evaluate(directions));
  if (directions.size() > 0) check_channels(result.read.size(), result.model.size());
  return result;
}

ConsumerError compare(const std::vector<const ReadValues*>& kinds) {
  ConsumerError result;
  std::vector<double> errors;
  result.maximum = -1;
  for (const ReadValues* kind : kinds)
    for (std::size_t c = 0; c < kind->model.size(); ++c)
      for (std::size_t k = 0; k < kind->directions.size(); ++k) {
        const double model = kind->model[c][k],
                     difference = std::abs(kind->read[c][k] - model) / std::max(model, error_floor);
        const double error = std::isnan(difference) ? INFINITY : difference;
        errors.push_back(error);
        if (!(error > result.maximum)) continue;
        result.maximum = error;
        result.theta_i = kind->directions.theta_i[k];
        result.theta_s = kind->directions.theta_s[k];
        result.phi = kind->directions.phi[k];
        result.channel = c;
        result.consumer = kind->read[c][k];
        result.model = model;
      }
  result.values = errors.size();
  result.maximum = std::max(result.maximum, 0.);
  result.median = lower_percentile(errors, 50);
  result.percentile_95 = lower_percentile(errors, 95);
  return result;
}

// Gives the median and the maximum of what `of` makes of two values of f.
template <class Of>
std::pair<double, double> spread(const Channels& a, const Channels& b, Of of) {
  std::vector<double> values;
  for (std::size_t band = 0; band < a.size(); ++band)
    for (std::size_t k = 0; k < a[band].size(); ++k)
      values.push_back(of(std::max(a[band][k], error_floor), std::max(b[band][k], error_floor)));
  const double median = lower_percentile(values, 50);
  return {median, lower_percentile(values, 100)};
}

std::string text(const ConsumerError& error) {
  return fmt::format(
      "{:.2g} % in the median, {:.2g} % at 95 %, {:.3g} % at most (theta_i {:.4g}, theta_s {:.4g}, phi "
      "{:.4g})",
      100 * error.median, 100 * error.percentile_95, 100 * error.maximum, error.theta_i, error.theta_s,
      error.phi);
}

}  // namespace

ReadExport read_export(const ExportReader& table, const ExportModel& source,
                       const ExportDirections& directions) {
  return {read_values(table, source, directions.uniform), read_values(table, source, directions.near_mirror),
          read_values(table, source, directions.near_retro)};
}

ExportErrors export_errors(const ReadExport& read, const ExportModel& source) {
  ExportErrors result;
  result.uniform = compare({&read.uniform});
  result.near_peaks = compare({&read.near_mirror, &read.near_retro});
  const Directions& uniform = read.uniform.directions;
  if (uniform.size() == 0) return result;
  std::tie(result.reciprocity_median, result.reciprocity_maximum) =
      spread(source.evaluate(uniform), source.evaluate(exchanged(uniform)),
             [](double a, double b) { return std::abs(std::log(a / b)); });
  std::tie(result.polarization_median, result.polarization_maximum) =
      spread(source.evaluate(uniform, Polarization::s), source.evaluate(uniform, Polarization::p),
             [](double s, double p) { return std::abs(s - p) / (s + p); });
  return result;
}

std::string summary(const ExportErrors& errors, const ExportFormat& format, const ExportReader& table) {
  std::string line = fmt::format(
      "read by {}, f is off by {} at {} random values; near the mirror and retro directions by {}",
      table.interpolation(), text(errors.uniform), errors.uniform.values, text(errors.near_peaks));
  if (!format.traits().holds_non_reciprocal)
    line += fmt::format("; not held: |ln f(i,s)/f(s,i)|, {:.2g} in the median, {:.2g} at most",
                        errors.reciprocity_median, errors.reciprocity_maximum);
  if (!format.traits().holds_polarization)
    line +=
        fmt::format("; not held: polarisation, |f_s - f_p|/(f_s + f_p) {:.2g} in the median, {:.2g} at most",
                    errors.polarization_median, errors.polarization_maximum);
  return line;
}

}  // namespace brdftab

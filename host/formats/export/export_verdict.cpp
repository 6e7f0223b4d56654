#include "host/formats/export/export_verdict.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"

namespace brdftab {
namespace {

using Channels = std::vector<std::vector<double>>;

constexpr std::array<double, 5> theta_bounds{0, 30, 60, 80, 90};
constexpr std::size_t at_median = 0, at_percentile_95 = 1, at_mean = 2;

// The directions of one region, named by where their polar angles lie; `rebuilt` has the values that the
// rebuilt file gives there.
struct Region {
  std::string name;
  const ReadValues* values;
  const Channels* rebuilt;
  std::vector<std::size_t> members;
};

std::array<double, 3> statistics(const Region& region, const std::vector<double>& read,
                                 const std::vector<double>& model) {
  std::vector<double> errors;
  double difference = 0, sum = 0;
  for (const std::size_t k : region.members) {
    const double f = std::max(model[k], error_floor), error = std::abs(read[k] - model[k]) / f;
    errors.push_back(std::isnan(error) ? INFINITY : error);
    difference += read[k] - model[k];
    sum += f;
  }
  const double share = difference / sum;
  return {lower_percentile(errors, 50), lower_percentile(errors, 95), std::isnan(share) ? INFINITY : share};
}

// Where the format's errors are large, f read is up to 1 + reached times f, and values off by the tolerance
// move it by as much.
double beyond(double reached, double tolerance) { return tolerance * (1 + std::abs(reached)); }

// The mean may lie between 0 and what the format reaches, and beyond either by the tolerance.
double allowed_mean(double file, double reached, double tolerance) {
  const double room = beyond(reached, tolerance);
  return file < 0 ? std::min(reached, 0.) - room : std::max(reached, 0.) + room;
}

void add_band_regions(std::vector<Region>& regions, const ReadValues& values, const Channels& rebuilt) {
  const auto all = [&](std::string name, const std::function<bool(std::size_t)>& holds) {
    Region region{std::move(name), &values, &rebuilt, {}};
    for (std::size_t k = 0; k < values.directions.size(); ++k)
      if (holds(k)) region.members.push_back(k);
    regions.push_back(std::move(region));
  };
  all("all directions", [](std::size_t) { return true; });
  for (const auto& [angle, theta] :
       {std::pair{"theta_i", &values.directions.theta_i}, {"theta_s", &values.directions.theta_s}})
    for (std::size_t band = 0; band + 1 < theta_bounds.size(); ++band)
      all(fmt::format("{} {} to {} degrees", angle, theta_bounds[band], theta_bounds[band + 1]),
          [&](std::size_t k) {
            return (*theta)[k] >= theta_bounds[band] && (*theta)[k] < theta_bounds[band + 1];
          });
}

Region whole(std::string name, const ReadValues& values, const Channels& rebuilt) {
  Region region{std::move(name), &values, &rebuilt, std::vector<std::size_t>(values.directions.size())};
  std::iota(region.members.begin(), region.members.end(), std::size_t{0});
  return region;
}

void check_wavelengths(const ExportReader& table, const ExportModel& source) {
  const auto file = table.wavelengths_nm(), material = source.wavelengths_nm();
  if (table.channels() != ExportChannels::bands || file.empty() || material.empty()) return;
  const auto same = [](double a, double b) { return std::abs(a - b) <= 1e-6 * b; };
  if (!std::equal(file.begin(), file.end(), material.begin(), material.end(), same))
    throw BadInput("the file's bands are {} nm, and its material's {} nm", fmt::join(file, ", "),
                   fmt::join(material, ", "));
}

std::string percent(double share) { return fmt::format("{:.3g} %", 100 * share); }

}  // namespace

double RegionStatistic::excess() const { return allowed < 0 ? allowed - file : file - allowed; }

std::size_t RegionErrors::worst() const {
  const auto less = [](const auto& a, const auto& b) { return a.excess() < b.excess(); };
  return static_cast<std::size_t>(std::max_element(statistics.begin(), statistics.end(), less) -
                                  statistics.begin());
}

bool ExportVerdict::good() const {
  return values.wrong() == 0 && std::all_of(regions.begin(), regions.end(), [](const RegionErrors& region) {
           return region.statistics[region.worst()].excess() <= 0;
         });
}

std::string ExportVerdict::fault() const {
  if (good()) return {};
  std::string text;
  const auto less = [](const RegionErrors& a, const RegionErrors& b) {
    return a.statistics[a.worst()].excess() < b.statistics[b.worst()].excess();
  };
  const auto worst = std::max_element(regions.begin(), regions.end(), less);
  if (worst != regions.end() && worst->statistics[worst->worst()].excess() > 0) {
    const std::size_t k = worst->worst();
    const RegionStatistic& statistic = worst->statistics[k];
    text =
        fmt::format("{}{}: f read is off by {} of f in the {}; the format reaches {}, allowed is {}",
                    worst->name, worst->channel == "f" ? "" : fmt::format(" in {}", worst->channel),
                    percent(statistic.file), k == at_percentile_95 ? "95th percentile" : statistic_names[k],
                    percent(statistic.reached), percent(statistic.allowed));
  }
  if (values.wrong() > 0)
    text +=
        fmt::format("{}{} of {} values are off by more than {} of f, most of all {}: {:.6g}, right is {:.6g}",
                    text.empty() ? "" : "; ", values.wrong(), values.values(), percent(tolerance),
                    values.place(), values.held(), values.right());
  return text;
}

std::vector<RegionErrors> ExportVerdict::worst_channels() const {
  std::vector<RegionErrors> result;
  for (const RegionErrors& region : regions) {
    const auto same =
        std::find_if(result.begin(), result.end(), [&](const auto& r) { return r.name == region.name; });
    if (same == result.end())
      result.push_back(region);
    else if (region.statistics[region.worst()].excess() > same->statistics[same->worst()].excess())
      *same = region;
  }
  return result;
}

ExportVerdict export_verdict(const ExportReader& table, const ExportModel& source, const ReadExport& read,
                             double tolerance) {
  check_wavelengths(table, source);
  ExportVerdict verdict{.tolerance = tolerance, .regions = {}, .values = ValueErrors(tolerance)};
  const auto right = table.rebuilt(source, verdict.values);
  const std::array<Channels, 3> rebuilt{right->evaluate(read.uniform.directions),
                                        right->evaluate(read.near_mirror.directions),
                                        right->evaluate(read.near_retro.directions)};
  std::vector<Region> regions;
  add_band_regions(regions, read.uniform, rebuilt[0]);
  regions.push_back(whole("near the mirror direction", read.near_mirror, rebuilt[1]));
  regions.push_back(whole("near the retro direction", read.near_retro, rebuilt[2]));
  for (const Region& region : regions) {
    if (region.members.empty()) continue;
    for (std::size_t c = 0; c < region.values->read.size(); ++c) {
      const auto& model = region.values->model[c];
      const auto file = statistics(region, region.values->read[c], model);
      const auto reached = statistics(region, (*region.rebuilt)[c], model);
      RegionErrors errors{region.name, channel_name(table.channels(), source, c), region.members.size(), {}};
      for (const std::size_t k : {at_median, at_percentile_95})
        errors.statistics[k] = {file[k], reached[k], reached[k] + beyond(reached[k], tolerance)};
      errors.statistics[at_mean] = {file[at_mean], reached[at_mean],
                                    allowed_mean(file[at_mean], reached[at_mean], tolerance)};
      verdict.regions.push_back(std::move(errors));
    }
  }
  return verdict;
}

}  // namespace brdftab

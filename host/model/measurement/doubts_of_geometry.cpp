// Directions, cosines and wavelengths may look like others than a file's layout says.
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/model/measurement/doubts.hpp"
#include "host/model/measurement/wavelength_unit.hpp"

namespace brdftab {
namespace {

// From here on a surface's forward scatter exceeds its backward scatter by far, unless it retro-reflects.
constexpr double high_incidence = 45;
constexpr double suspicious_asymmetry = 2;
// A retro-reflecting lobe has its peak within this distance, in direction cosines.
constexpr double retro_lobe = 0.1;
constexpr std::size_t few_views = 5;
// Samples at scattered directions fill groups of incidences of this width, degrees, not one of them.
constexpr double wide_incidence = 10;

bool is_backward(const DirectionPair& pair) { return std::cos(radians(pair.model_phi())) < 0; }

double distance_from_retro(const DirectionPair& pair) {
  const double sine = std::sin(radians(pair.model_theta_s())), phi = radians(pair.model_phi());
  return std::hypot(sine * std::cos(phi) + std::sin(radians(pair.theta_i)), sine * std::sin(phi));
}

// A sample counts as in the plane of incidence if it is so many degrees out of it; interpolation may bridge
// so many between neighbours.
constexpr double in_plane = 1;
constexpr double widest_gap = 16;

/// This is ln f of one incidence in plane over signed theta_s, where the forward side is positive.
using Scan = std::map<double, double>;

std::optional<double> ln_f(const Scan& scan, double theta_s) {
  const auto above = scan.lower_bound(theta_s);
  if (above == scan.end()) return std::nullopt;
  if (above->first == theta_s) return above->second;
  if (above == scan.begin()) return std::nullopt;
  const auto below = std::prev(above);
  const double gap = above->first - below->first;
  if (gap > widest_gap) return std::nullopt;
  const double share = (theta_s - below->first) / gap;
  return below->second + share * (above->second - below->second);
}

std::map<std::pair<std::size_t, std::size_t>, Scan> scans_in_plane(const Measurement& measurement,
                                                                   const Incidences& incidences) {
  std::map<std::pair<std::size_t, std::size_t>, Scan> scans;
  for (const auto& [pair, brdf, sigma, channel, share_s] : measurement.samples) {
    const double theta_s = pair.model_theta_s(), phi = radians(pair.model_phi());
    if (!(brdf > 0) || (theta_s > 0 && std::abs(std::sin(phi)) > std::sin(radians(in_plane)))) continue;
    scans[{channel, incidences.index(pair.theta_i)}][is_backward(pair) ? -theta_s : theta_s] = std::log(brdf);
  }
  return scans;
}

}  // namespace

std::string doubt_of_azimuth(const Measurement& measurement) {
  const Incidences incidences = measurement.incidences();
  const double highest = incidences.angles().back();
  if (highest < high_incidence) return {};
  double forward = 0, backward = 0;
  for (const auto& [pair, brdf, sigma, channel, share_s] : measurement.samples) {
    if (incidences.index(pair.theta_i) + 1 < incidences.size() || !(pair.model_theta_s() > 0)) continue;
    if (!is_backward(pair))
      forward = std::max(forward, brdf);
    else if (distance_from_retro(pair) >= retro_lobe)
      backward = std::max(backward, brdf);
  }
  if (!(forward > 0 && backward > suspicious_asymmetry * forward)) return {};
  return fmt::format(
      "at theta_i = {} degrees the peak is on the backward side, {:.3g} against {:.3g} 1/sr: unless the "
      "material retro-reflects, the azimuth is counted from the other side; `flip_azimuth` turns it",
      shortest(highest), backward, forward);
}

std::string doubt_of_cosine(const Measurement& measurement) {
  // Where light and view change places f stays, and f cos theta_s changes by the ratio of the cosines.
  constexpr double least_contrast = 0.3, least_defect = 0.15;
  // The model itself is not reciprocal, most at grazing: with N and V_m its f comes to 0.9 of the defect
  // where it is divided.
  constexpr double largest_theta = 80, clearly_less = 0.75;
  constexpr std::size_t fewest_pairs = 2;
  const Incidences incidences = measurement.incidences();
  const auto scans = scans_in_plane(measurement, incidences);
  double as_read = 0, if_divided = 0, contrast = 0;
  std::size_t pairs = 0;
  for (const auto& [key, scan] : scans)
    for (const auto& [other_key, other] : scans) {
      if (other_key.first != key.first || other_key.second <= key.second) continue;
      const double theta = incidences.angles()[key.second],
                   other_theta = incidences.angles()[other_key.second];
      if (std::max(theta, other_theta) > largest_theta) continue;
      const double expected = std::log(std::cos(radians(other_theta)) / std::cos(radians(theta)));
      for (const int side : {1, -1}) {
        const auto there = ln_f(scan, side * other_theta), back = ln_f(other, side * theta);
        if (!there || !back) continue;
        const double defect = *there - *back;
        as_read += defect * defect;
        if_divided += (defect - expected) * (defect - expected);
        contrast += expected * expected;
        ++pairs;
      }
    }
  const auto count = static_cast<double>(pairs);
  if (pairs < fewest_pairs || contrast < count * least_contrast * least_contrast) return {};
  if (if_divided >= clearly_less * clearly_less * as_read || as_read < count * least_defect * least_defect)
    return {};
  return fmt::format(
      "light and view cannot change places: ln f differs by {:.2g} in {} pairs of directions in plane, and "
      "by {:.2g} if divided by cos theta_s: this looks like f cos theta_s; `values` cosine-weighted mends "
      "that",
      std::sqrt(as_read / count), pairs, std::sqrt(if_divided / count));
}

std::string doubt_of_geometry(const Measurement& measurement) {
  using Views = std::set<std::pair<double, double>>;
  const Incidences incidences = measurement.incidences();
  std::vector<double> theta_i;
  for (const auto& sample : measurement.samples) theta_i.push_back(sample.pair.theta_i);
  const Incidences wide(theta_i, wide_incidence);
  std::vector<Views> views(incidences.size());
  // Angles are counted in whole degrees, as they are and from the mirror direction: either may be the setting
  // of the instrument.
  std::vector<Views> absolute(wide.size()), relative(wide.size());
  for (const auto& sample : measurement.samples) {
    const DirectionPair& pair = sample.pair;
    const double theta_s = pair.model_theta_s(),
                 phi = theta_s == 0 ? 0 : std::abs(std::remainder(pair.model_phi(), 360));
    views[incidences.index(pair.theta_i)].insert({theta_s, phi});
    absolute[wide.index(pair.theta_i)].insert({std::round(theta_s), std::round(phi)});
    relative[wide.index(pair.theta_i)].insert({std::round(theta_s - pair.theta_i), std::round(phi)});
  }
  const auto are_few = [](const Views& v) { return v.size() < few_views; };
  const auto few = static_cast<std::size_t>(std::count_if(views.begin(), views.end(), are_few));
  std::size_t few_in_groups = 0;
  for (std::size_t k = 0; k < wide.size(); ++k) few_in_groups += are_few(absolute[k]) || are_few(relative[k]);
  if (2 * few <= views.size() || 2 * few_in_groups <= wide.size()) return {};
  const bool is_one = std::all_of(views.begin(), views.end(), [](const Views& v) { return v.size() == 1; });
  return fmt::format(
      "{} of {} incidences have {}: how f falls off along theta_s and phi is hardly in the data, so widths "
      "(rho) and heights (sigma) of lobes are not told apart; `fix` holds what is known",
      few, views.size(),
      is_one ? std::string("one direction of view only")
             : fmt::format("fewer than {} directions of view", few_views));
}

std::string doubt_of_wavelengths(const Measurement& measurement) {
  double low = HUGE_VAL, high = 0;
  bool are_counted = true;
  for (std::size_t c = 0; c < measurement.channels.size(); ++c) {
    const auto nm = measurement.wavelength_nm(c);
    if (!nm) return {};
    low = std::min(low, *nm);
    high = std::max(high, *nm);
    are_counted = are_counted && *nm == static_cast<double>(c + 1);
  }
  // Channels 1, 2, 3 are names.
  if (are_counted || (is_plausible_wavelength(low) && is_plausible_wavelength(high))) return {};
  std::string line = fmt::format("wavelengths of {:.6g} to {:.6g} nm are not within {:.0f} nm to {:.0f} um",
                                 low, high, least_plausible_nm, largest_plausible_nm / 1e3);
  for (const WavelengthUnit& unit : wavelength_units)
    if (unit.nm != 1 && is_plausible_wavelength(low * unit.nm) && is_plausible_wavelength(high * unit.nm))
      return line + fmt::format(": as {} they are {:.6g} to {:.6g} nm; `wavelength_unit` {} takes them so",
                                unit.name, low * unit.nm, high * unit.nm, unit.name);
  return line + "; `wavelength_unit` says their unit";
}

}  // namespace brdftab

#include "host/model/measurement/measured_light.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

constexpr std::array<Polarization, 3> all_light{Polarization::unpolarized, Polarization::s, Polarization::p};

bool has(const Measurement& measurement, Polarization light) {
  return std::any_of(measurement.samples.begin(), measurement.samples.end(),
                     [&](const MeasuredSample& sample) { return sample.share_s == share_s(light); });
}

// Makes the mean of the two samples that each row has; independent errors add in squares.
void take_means(Measurement& measurement) {
  std::map<std::pair<std::size_t, std::size_t>, MeasuredSample> of_s;  // by line and channel
  std::vector<MeasuredSample> means;
  for (const MeasuredSample& sample : measurement.samples) {
    const std::pair key{sample.pair.line, sample.channel};
    if (sample.share_s == share_s(Polarization::s)) of_s.emplace(key, sample);
  }
  for (MeasuredSample sample : measurement.samples) {
    const auto s = of_s.find({sample.pair.line, sample.channel});
    if (sample.share_s != share_s(Polarization::p) || s == of_s.end()) continue;
    sample.brdf = 0.5 * (sample.brdf + s->second.brdf);
    sample.sigma = 0.5 * std::hypot(sample.sigma, s->second.sigma);
    sample.share_s = share_s(Polarization::unpolarized);
    means.push_back(sample);
  }
  measurement.samples = std::move(means);
  measurement.warnings.push_back(
      "f of unpolarised light is taken as the mean of brdf_s and brdf_p; `polarization` s, p or all takes "
      "them as they are");
}

}  // namespace

std::string_view light_word(double share_s) {
  return share_s == 1 ? "s-polarised" : share_s == 0 ? "p-polarised" : "unpolarised";
}

std::vector<Polarization> light_named(const std::string& name) {
  if (name == "all") return {Polarization::s, Polarization::p};
  const auto at = std::find(polarization_names.begin(), polarization_names.end(), name);
  if (at == polarization_names.end())
    throw BadInput(GivenValue{"polarization", name}, "must be unpolarized, s, p or all");
  return {static_cast<Polarization>(at - polarization_names.begin())};
}

void choose_light(Measurement& measurement, const std::vector<Polarization>& light, bool tells_light) {
  if (!tells_light) {
    if (light.size() > 1)
      throw BadInput("{}: `polarization` all takes a CSV file with the columns brdf_s and brdf_p",
                     measurement.source);
    for (MeasuredSample& sample : measurement.samples) sample.share_s = share_s(light.front());
    return;
  }
  if (measurement.samples.empty()) return;
  if (light == std::vector{Polarization::unpolarized} && !has(measurement, Polarization::unpolarized) &&
      has(measurement, Polarization::s) && has(measurement, Polarization::p)) {
    take_means(measurement);
    return;
  }
  for (const Polarization wanted : light) {
    if (has(measurement, wanted)) continue;
    std::vector<std::string> there;
    for (const Polarization other : all_light)
      if (has(measurement, other))
        there.push_back(fmt::format("{} ({})", brdf_name(other), light_word(share_s(other))));
    throw BadInput(
        "{}: has no column {} (or {}_per_sr) of {} light; it has {}: `polarization` takes what is there",
        measurement.source, brdf_name(wanted), brdf_name(wanted), light_word(share_s(wanted)),
        fmt::join(there, ", "));
  }
  std::erase_if(measurement.samples, [&](const MeasuredSample& sample) {
    return std::none_of(light.begin(), light.end(),
                        [&](Polarization wanted) { return sample.share_s == share_s(wanted); });
  });
}

}  // namespace brdftab

#include "host/table/energy.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"
#include "host/compute/evaluate.hpp"
#include "host/compute/on_host/kernels_on_host.hpp"

namespace brdftab {

namespace {

// Each pair of directions, and the same pair exchanged behind it.
std::vector<DirectionPair> there_and_back() {
  std::vector<DirectionPair> pairs;
  for (int i = 5; i <= 85; i += 5)
    for (int s = i + 5; s <= 85; s += 5)
      for (int phi = 0; phi <= 180; phi += 15) {
        pairs.push_back({double(i), double(s), double(phi), 0});
        pairs.push_back({double(s), double(i), double(phi), 0});
      }
  return pairs;
}

Reciprocity defect(const std::vector<DirectionPair>& pairs, const std::vector<PolarizedBrdf>& f) {
  Reciprocity result;
  std::vector<double> defects;
  for (std::size_t k = 0; k < pairs.size(); k += 2) {
    const double forth = f[k].unpolarized();
    const double back = f[k + 1].unpolarized();
    // Where the model scatters nothing either way there is nothing to compare.
    if (forth == 0 && back == 0) continue;
    const double logarithm = std::abs(std::log(forth / back));
    if (logarithm > result.maximum) {
      result.maximum = logarithm;
      result.theta_i = pairs[k].theta_i;
      result.theta_s = pairs[k].theta_s;
      result.phi = pairs[k].phi;
    }
    defects.push_back(logarithm);
  }
  result.pairs = defects.size();
  if (defects.empty()) return result;
  result.median = median(defects);
  result.percentile_90 = percentile(defects, 90);
  return result;
}

}  // namespace

std::vector<std::string> energy_warnings(const Material& material, const Band& band,
                                         std::span<const double> theta_i, const Dhr& dhr,
                                         const std::vector<Polarization>& polarizations) {
  std::vector<std::string> warnings;
  for (const Polarization polarization : polarizations) {
    std::size_t worst = 0;
    std::size_t above = 0;
    for (std::size_t k = 0; k < theta_i.size(); ++k) {
      if (dhr.total(k, polarization) > dhr.total(worst, polarization)) worst = k;
      if (dhr.total(k, polarization) > 1) ++above;
    }
    if (above == 0) continue;
    std::size_t lobe = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (dhr.lobe(k, worst, polarization) > dhr.lobe(lobe, worst, polarization)) lobe = k;
    warnings.push_back(fmt::format(
        "{}{}: DHR is above 1 at {} of {} theta_i ({} light): {:.6g} at theta_i = {} degrees, where the {} "
        "lobe has {:.6g}",
        material.name(), band.wavelength_nm ? fmt::format(", {} nm", shortest(*band.wavelength_nm)) : "",
        above, theta_i.size(),
        polarization == Polarization::unpolarized
            ? "unpolarised"
            : polarization_names[static_cast<std::size_t>(polarization)],
        dhr.total(worst, polarization), shortest(theta_i[worst]), lobe_names[lobe],
        dhr.lobe(lobe, worst, polarization)));
  }
  return warnings;
}

Reciprocity reciprocity(const Band& band, const Variant& variant) {
  const auto pairs = there_and_back();
  std::vector<PolarizedBrdf> f;
  for (const auto& sample : kernels_on_host::Double::brdf(band.parameters, variant, pairs)) {
    // A Gaussian lobe whose N overflows at an angle that a table need not have: the reference works in
    // logarithms.
    if (!std::isfinite(sample.s) || !std::isfinite(sample.p)) return reference_reciprocity(band, variant);
    f.push_back({sample.s, sample.p});
  }
  return defect(pairs, f);
}

Reciprocity reference_reciprocity(const Band& band, const Variant& variant) {
  const auto pairs = there_and_back();
  return defect(pairs, evaluate_reference(band, variant, pairs));
}

}  // namespace brdftab

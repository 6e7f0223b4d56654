#include "host/compute/sampled_model.hpp"

#include <algorithm>
#include <cmath>

namespace brdftab {
namespace {

constexpr std::size_t peak_angles = 201;
constexpr std::size_t at_once = 1 << 18;

}  // namespace

SampledModel::SampledModel(const Engine& engine, const Material& material,
                           const std::vector<Polarization>& polarizations, AngleRange theta_i,
                           AngleRange theta_s)
    : engine_(engine),
      polarizations_(polarizations),
      theta_i_(theta_i),
      theta_s_(theta_s),
      last_(std::max({theta_i.last, theta_s.last, 1.0})),
      reciprocal_(material.variant().normalization == Normalization::reciprocal) {
  for (const Band& band : material.bands())
    bands_.push_back({KernelMaterial(band.parameters, material.variant(), engine.working()),
                      NormalizationCurve(engine, band, material.variant(), last_)});
}

double SampledModel::place(double theta) const { return 1 - std::sqrt(std::max(1 - theta / last_, 0.0)); }

double SampledModel::angle(double place) const { return std::min(last_ * place * (2 - place), last_); }

void SampledModel::find_peaks() const {
  // In the planes where lobes lie and between; the forward peak itself, at theta_s = theta_i, is among them.
  Directions directions;
  std::vector<double> azimuths{0, 15, 45, 90, 135, 165, 180};
  const double step = 1.0 / static_cast<double>(peak_angles - 1);
  for (std::size_t a = 0; a < peak_angles; ++a) {
    const double theta_i = std::clamp(angle(static_cast<double>(a) * step), theta_i_.first, theta_i_.last);
    for (const double phi : azimuths) {
      directions.add(theta_i, std::clamp(theta_i, theta_s_.first, theta_s_.last), phi);
      for (std::size_t s = 0; s < peak_angles; ++s)
        directions.add(theta_i,
                       std::clamp(angle(static_cast<double>(s) * step), theta_s_.first, theta_s_.last), phi);
    }
  }
  const std::size_t block = directions.size() / peak_angles;
  for (const auto& f : evaluate(directions)) {
    std::vector<double> logarithms;
    for (std::size_t a = 0; a < peak_angles; ++a) {
      const auto begin = f.begin() + static_cast<std::ptrdiff_t>(a * block);
      logarithms.push_back(
          std::log(std::max(*std::max_element(begin, begin + static_cast<std::ptrdiff_t>(block)), 1e-300)));
    }
    log_peak_.emplace_back(logarithms.begin(), logarithms.end(), 0, step);
  }
}

double SampledModel::peak(std::size_t brdf, double theta_i) const {
  if (log_peak_.empty()) find_peaks();
  return std::exp(log_peak_[brdf](place(theta_i)));
}

std::vector<std::vector<double>> SampledModel::evaluate(const Directions& directions) const {
  std::vector<std::vector<double>> f(brdfs(), std::vector<double>(directions.size()));
  for (std::size_t begin = 0; begin < directions.size(); begin += at_once) {
    engine_.watch().stop_if_asked();
    evaluate_part(directions, begin, std::min(at_once, directions.size() - begin), f);
  }
  return f;
}

void SampledModel::evaluate_part(const Directions& directions, std::size_t begin, std::size_t count,
                                 std::vector<std::vector<double>>& f) const {
  const std::size_t padded = engine_.padded_directions(count);
  const auto part = [&](const std::vector<double>& all) {
    std::vector<double> values(padded, all[begin + count - 1]);
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(begin), count, values.begin());
    return values;
  };
  const auto theta_i = part(directions.theta_i), theta_s = part(directions.theta_s),
             phi = part(directions.phi);
  // N of each direction of incidence, then, where it counts, of each of scatter.
  std::vector<int> incidence(padded), scatter(padded);
  const int first_scatter = reciprocal_ ? static_cast<int>(padded) : 0;
  for (std::size_t k = 0; k < padded; ++k) {
    incidence[k] = static_cast<int>(k);
    scatter[k] = first_scatter + static_cast<int>(k);
  }
  std::vector<NormalizationCurve::Stencil> stencils;
  stencils.reserve(2 * padded);
  for (const double theta : theta_i) stencils.push_back(NormalizationCurve::stencil(theta));
  if (reciprocal_)
    for (const double theta : theta_s) stencils.push_back(NormalizationCurve::stencil(theta));
  const std::size_t bytes = padded * bytes_of(engine_.working());
  const cl::Buffer f_s = engine_.buffer(bytes), f_p = engine_.buffer(bytes);
  const std::array angles{engine_.upload_polar_angles(theta_i), engine_.upload_polar_angles(theta_s),
                          engine_.upload(phi)};
  const std::array index{engine_.upload(std::span<const int>(incidence)),
                         engine_.upload(std::span<const int>(scatter))};
  const std::size_t angles_of_n = stencils.size();
  std::vector<double> n(3 * angles_of_n);
  for (std::size_t band = 0; band < bands_.size(); ++band) {
    for (std::size_t lobe = 0; lobe < 3; ++lobe)
      for (std::size_t k = 0; k < angles_of_n; ++k)
        n[lobe * angles_of_n + k] = bands_[band].n(lobe, stencils[k]);
    const cl::Buffer normalization = engine_.upload(n);
    cl::Kernel kernel = engine_.directions_kernel("evaluate");
    set_arguments(kernel, angles[0], angles[1], angles[2], index[0], index[1], normalization,
                  static_cast<cl_int>(angles_of_n), f_s, f_p);
    bands_[band].kernel.set(kernel, 9);
    engine_.run_directions(kernel, padded);
    const auto s = engine_.download(f_s, padded), p = engine_.download(f_p, padded);
    for (std::size_t j = 0; j < polarizations_.size(); ++j) {
      auto& out = f[band * polarizations_.size() + j];
      for (std::size_t k = 0; k < count; ++k)
        out[begin + k] = polarizations_[j] == Polarization::s   ? s[k]
                         : polarizations_[j] == Polarization::p ? p[k]
                                                                : 0.5 * (s[k] + p[k]);
    }
  }
}

}  // namespace brdftab

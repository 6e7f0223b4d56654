#include "host/formats/export/export_model.hpp"

#include <algorithm>
#include <cmath>
#include <unordered_set>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/evaluate.hpp"
#include "host/compute/integrals.hpp"

namespace brdftab {
namespace {

// Up to so many polar angles N is integrated at each; for more of them a curve through as many costs less.
constexpr std::size_t most_integrals = 600;
// N's curve reaches at least to this polar angle, degrees.
constexpr double largest_theta = 89.9999;

double polarized(const PolarizedBrdf& f, Polarization polarization) {
  return polarization == Polarization::s ? f.s : polarization == Polarization::p ? f.p : f.unpolarized();
}

bool are_few(const std::vector<double>& theta) {
  std::unordered_set<double> distinct;
  for (const double angle : theta)
    if (distinct.insert(angle).second && distinct.size() > most_integrals) return false;
  return true;
}

}  // namespace

ExportModel::ExportModel(const Engine& engine, Material material, ExportChoice choice)
    : engine_(engine), material_(std::move(material)), choice_(std::move(choice)) {}

std::vector<double> ExportModel::wavelengths_nm() const {
  std::vector<double> result;
  for (const Band& band : material_.bands())
    if (band.wavelength_nm) result.push_back(*band.wavelength_nm);
  return result;
}

std::vector<std::vector<double>> ExportModel::values(const Directions& directions,
                                                     Polarization polarization) const {
  const bool reciprocal = material_.variant().normalization == Normalization::reciprocal;
  if (!are_few(directions.theta_i) || (reciprocal && !are_few(directions.theta_s))) {
    const double last = std::max(std::ranges::max(directions.theta_i), std::ranges::max(directions.theta_s));
    if (!sampled_ || last > sampled_to_) {
      sampled_to_ = std::max(last, largest_theta);
      sampled_ =
          std::make_unique<SampledModel>(engine_, material_, std::vector{Polarization::s, Polarization::p},
                                         AngleRange{0, sampled_to_}, AngleRange{0, sampled_to_});
    }
    const auto by_brdf = sampled_->evaluate(directions);
    std::vector<std::vector<double>> f(bands(), std::vector<double>(directions.size()));
    for (std::size_t band = 0; band < f.size(); ++band)
      for (std::size_t k = 0; k < directions.size(); ++k)
        f[band][k] = polarized({by_brdf[2 * band][k], by_brdf[2 * band + 1][k]}, polarization);
    return f;
  }
  std::vector<DirectionPair> pairs;
  pairs.reserve(directions.size());
  for (std::size_t k = 0; k < directions.size(); ++k)
    pairs.push_back({.theta_i = directions.theta_i[k],
                     .theta_s = directions.theta_s[k],
                     .phi = directions.phi[k],
                     .line = 0});
  std::vector<std::vector<double>> f;
  for (const Band& band : material_.bands()) {
    auto& values = f.emplace_back();
    values.reserve(pairs.size());
    for (const PolarizedBrdf& value : brdftab::evaluate(engine_, band, material_.variant(), pairs))
      values.push_back(polarized(value, polarization));
  }
  return f;
}

std::vector<std::vector<double>> ExportModel::evaluate(const Directions& directions,
                                                       Polarization polarization) const {
  auto f = values(directions, polarization);
  for (const auto& band : f) {
    const auto at =
        std::find_if_not(band.begin(), band.end(), [](double value) { return std::isfinite(value); });
    if (at == band.end()) continue;
    const auto k = static_cast<std::size_t>(at - band.begin());
    throw BadInput("{}: f is not finite at theta_i = {}, theta_s = {}, phi = {} degrees", material_.name(),
                   shortest(directions.theta_i[k]), shortest(directions.theta_s[k]),
                   shortest(directions.phi[k]));
  }
  return f;
}

std::vector<std::vector<double>> ExportModel::dhr(std::span<const double> theta_i,
                                                  Polarization polarization) const {
  std::vector<std::vector<double>> result;
  for (const Band& band : material_.bands()) {
    const Dhr dhr = integrals(engine_, band, material_.variant(), theta_i).dhr;
    auto& values = result.emplace_back();
    for (std::size_t k = 0; k < theta_i.size(); ++k) values.push_back(dhr.total(k, polarization));
  }
  return result;
}

std::vector<std::vector<double>> ExportModel::xyz(const std::vector<std::vector<double>>& by_band) const {
  return weighted(xyz_weights(wavelengths_nm(), choice_.illuminant), by_band);
}

std::vector<std::vector<double>> ExportModel::rgb(const std::vector<std::vector<double>>& by_band) const {
  return weighted(rgb_weights(wavelengths_nm(), choice_.illuminant), by_band);
}

}  // namespace brdftab

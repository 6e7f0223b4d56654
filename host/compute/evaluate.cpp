#include "host/compute/evaluate.hpp"

#include <algorithm>
#include <unordered_map>

#include "host/compute/normalizations.hpp"
#include "host/reference/model.hpp"

namespace brdftab {
namespace {

constexpr std::size_t pairs_at_once = 1 << 20;
// Distinct values, and the index of each value among them.
struct Distinct {
  std::vector<double> values;
  std::vector<int> index;
};

Distinct distinct(const std::vector<double>& all) {
  Distinct result;
  result.index.reserve(all.size());
  std::unordered_map<double, int> known;
  for (const double value : all) {
    const auto [at, is_new] = known.try_emplace(value, static_cast<int>(result.values.size()));
    if (is_new) result.values.push_back(value);
    result.index.push_back(at->second);
  }
  return result;
}

void evaluate_part(const Engine& engine, const Band& band, const Variant& variant,
                   std::span<const DirectionPair> pairs, std::vector<PolarizedBrdf>& out) {
  const std::size_t padded = engine.padded_directions(pairs.size());
  std::vector<double> theta_i(padded), theta_s(padded), phi(padded);
  for (std::size_t k = 0; k < padded; ++k) {
    const DirectionPair& pair = pairs[std::min(k, pairs.size() - 1)];
    theta_i[k] = pair.theta_i;
    theta_s[k] = pair.model_theta_s();
    phi[k] = pair.model_phi();
  }
  // N is integrated once for each angle; at theta_s it is needed for reciprocal normalisation only.
  const bool reciprocal = variant.normalization == Normalization::reciprocal;
  std::vector<double> angles = theta_i;
  if (reciprocal) angles.insert(angles.end(), theta_s.begin(), theta_s.end());
  const Distinct thetas = distinct(angles);
  const Normalizations n = normalizations(engine, band, variant, thetas.values);
  const std::span<const int> incidence(thetas.index.data(), padded);
  const std::span<const int> scatter(thetas.index.data() + (reciprocal ? padded : 0), padded);

  const std::size_t bytes = padded * bytes_of(engine.working());
  const cl::Buffer f_s = engine.buffer(bytes);
  const cl::Buffer f_p = engine.buffer(bytes);
  const std::array angles_of_pairs{engine.upload_polar_angles(theta_i), engine.upload_polar_angles(theta_s),
                                   engine.upload(phi)};
  const std::array n_of_pairs{engine.upload(incidence), engine.upload(scatter)};
  cl::Kernel kernel = engine.directions_kernel("evaluate");
  set_arguments(kernel, angles_of_pairs[0], angles_of_pairs[1], angles_of_pairs[2], n_of_pairs[0],
                n_of_pairs[1], n.on_device, static_cast<cl_int>(thetas.values.size()), f_s, f_p);
  KernelMaterial(band.parameters, variant, engine.working()).set(kernel, 9);
  engine.run_directions(kernel, padded);
  const auto s = engine.download(f_s, padded);
  const auto p = engine.download(f_p, padded);
  for (std::size_t k = 0; k < pairs.size(); ++k) out.push_back({s[k], p[k]});
}

}  // namespace

std::vector<PolarizedBrdf> evaluate(const Engine& engine, const Band& band, const Variant& variant,
                                    std::span<const DirectionPair> pairs) {
  std::vector<PolarizedBrdf> result;
  result.reserve(pairs.size());
  for (std::size_t begin = 0; begin < pairs.size(); begin += pairs_at_once) {
    engine.watch().stop_if_asked();
    evaluate_part(engine, band, variant, pairs.subspan(begin, std::min(pairs_at_once, pairs.size() - begin)),
                  result);
  }
  return result;
}

std::vector<PolarizedBrdf> evaluate_reference(const Band& band, const Variant& variant,
                                              std::span<const DirectionPair> pairs, const Watch& watch) {
  const reference::Model model(band.parameters, variant);
  std::vector<PolarizedBrdf> result;
  result.reserve(pairs.size());
  for (const DirectionPair& pair : pairs) {
    watch.stop_if_asked();
    const auto f = model.brdf(pair.theta_i, pair.model_theta_s(), pair.model_phi());
    result.push_back({f.s.total(), f.p.total()});
  }
  return result;
}

}  // namespace brdftab

#include "host/compute/gradients.hpp"

#include <boost/math/special_functions/digamma.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "host/base/error.hpp"
#include "host/compute/normalization_nodes.hpp"

namespace brdftab {
namespace {

// Work-items in a work-group; lists are filled up to whole ones, so that PoCL compiles one local size for
// all.
constexpr std::size_t group = 8;
// Bounds the memory that one launch takes.
constexpr std::size_t most_materials_at_once = 256;
// N and its three derivatives, of three lobes.
constexpr std::size_t n_rows = 12;

}  // namespace

template <class Constants>
Constants gradient_constants(const Parameters& parameters) {
  using Real = decltype(Constants::scale_slope);
  const long double a = 1 + static_cast<long double>(parameters.n);
  Constants constants{.m = material_constants<decltype(Constants::m)>(parameters),
                      .scale_slope = static_cast<Real>(std::log(a) - boost::math::digamma(1 + a))};
  // The derivative by a of the incomplete gamma function's expansions converges a little later than they do.
  const auto more = [](Real terms) { return terms > 0 ? std::ceil(terms * Real(1.2)) + 4 : Real(0); };
  constants.m.series_terms = more(constants.m.series_terms);
  constants.m.fraction_terms = more(constants.m.fraction_terms);
  return constants;
}

template kernel_f64::GradientConstants gradient_constants(const Parameters&);
template kernel_f32::GradientConstants gradient_constants(const Parameters&);

LogBrdfValues LogBrdfValues::mean_of_exchanges(std::size_t materials) const {
  const std::size_t half = pairs_ / 2;
  std::vector<double> values(materials * rows * half);
  for (std::size_t m = 0; m < materials; ++m) {
    const auto ln_f = row(m * rows);
    for (std::size_t k = 0; k < half; ++k) {
      const double here = ln_f[k], exchanged = ln_f[half + k], larger = std::max(here, exchanged);
      const double mean = larger + std::log(0.5 * (std::exp(here - larger) + std::exp(exchanged - larger)));
      const double share = 0.5 * std::exp(here - mean);
      values[m * rows * half + k] = mean;
      for (std::size_t p = 1; p < rows; ++p) {
        const auto by = row(m * rows + p);
        values[(m * rows + p) * half + k] = share * by[k] + (1 - share) * by[half + k];
      }
    }
  }
  return {std::move(values), half, half};
}

std::vector<DirectionPair> with_exchanges(std::vector<DirectionPair> pairs) {
  const std::size_t count = pairs.size();
  for (std::size_t k = 0; k < count; ++k) {
    const DirectionPair pair = pairs[k];
    pairs.push_back({.theta_i = pair.model_theta_s(),
                     .theta_s = pair.theta_i,
                     .phi = pair.model_phi(),
                     .line = pair.line});
  }
  return pairs;
}

LogBrdfGradients::LogBrdfGradients(const Engine& engine, std::span<const DirectionPair> pairs, double share_s,
                                   const Variant& variant)
    : LogBrdfGradients(engine, pairs, std::vector<double>(pairs.size(), share_s), variant) {}

LogBrdfGradients::LogBrdfGradients(const Engine& engine, std::span<const DirectionPair> pairs,
                                   std::span<const double> share_s, const Variant& variant)
    : engine_(engine), pairs_(pairs.size()), variant_(variant) {
  if (variant.normalization == Normalization::closed_form ||
      variant.autocovariance != Autocovariance::lorentzian)
    throw BadInput(
        "a fit takes normalization = hemispherical or reciprocal and autocovariance = lorentzian: the others "
        "have no derivatives");
  const std::size_t together = group * engine.directions_width();
  padded_ = (pairs.size() + together - 1) / together * together;
  std::vector<double> theta_i(padded_), theta_s(padded_), phi(padded_), shares(padded_), angles;
  std::vector<int> incidence(padded_), scatter(padded_);
  std::map<double, int> known;
  const auto index_of = [&](double theta) {
    const auto [at, is_new] = known.try_emplace(theta, static_cast<int>(angles.size()));
    if (is_new) angles.push_back(theta);
    return at->second;
  };
  for (std::size_t k = 0; k < padded_; ++k) {
    const DirectionPair& pair = pairs[std::min(k, pairs.size() - 1)];
    shares[k] = share_s[std::min(k, pairs.size() - 1)];
    theta_i[k] = pair.theta_i;
    theta_s[k] = pair.model_theta_s();
    phi[k] = pair.model_phi();
    incidence[k] = index_of(theta_i[k]);
    // N at theta_s matters for reciprocal normalisation only.
    scatter[k] = variant.normalization == Normalization::reciprocal ? index_of(theta_s[k]) : incidence[k];
  }
  angles_ = angles.size();
  const NormalizationNodes nodes(angles);
  nodes_ = nodes.theta().size();
  interpolates_ = nodes.interpolates();
  nodes_theta_ = engine.upload_polar_angles(nodes.theta());
  if (interpolates_) {
    node_first_ = engine.upload(nodes.first());
    node_count_ = engine.upload(nodes.count());
    node_share_ = engine.upload(nodes.share());
  }
  theta_i_ = engine.upload_polar_angles(theta_i);
  theta_s_ = engine.upload_polar_angles(theta_s);
  phi_ = engine.upload(phi);
  share_s_ = engine.upload(shares);
  incidence_ = engine.upload(incidence);
  scatter_ = engine.upload(scatter);
}

LogBrdfValues LogBrdfGradients::evaluate(std::span<const Parameters> materials) const {
  constexpr std::size_t rows = 1 + parameter_table.size();
  std::vector<double> values;
  values.reserve(materials.size() * rows * padded_);
  const auto bytes_of_materials = [&](std::span<const Parameters> part) {
    std::vector<std::byte> bytes;
    const auto append = [&](const auto& constants) {
      const auto raw = std::as_bytes(std::span(&constants, 1));
      bytes.insert(bytes.end(), raw.begin(), raw.end());
    };
    for (const Parameters& p : part) {
      if (engine_.working() == Precision::float64)
        append(gradient_constants<kernel_f64::GradientConstants>(p));
      else
        append(gradient_constants<kernel_f32::GradientConstants>(p));
    }
    return bytes;
  };
  for (std::size_t begin = 0; begin < materials.size(); begin += most_materials_at_once) {
    const auto part = materials.subspan(begin, std::min(most_materials_at_once, materials.size() - begin));
    const auto constants = bytes_of_materials(part);
    const cl::Buffer on_device = engine_.upload(std::span<const std::byte>(constants));
    const auto n_of = [&](std::size_t angles) {
      return engine_.buffer(part.size() * n_rows * angles * bytes_of(engine_.working()));
    };
    cl::Buffer n = n_of(nodes_);
    const cl::Buffer out = engine_.buffer(part.size() * rows * padded_ * bytes_of(engine_.working()));
    const auto variant = model_variant<kernel_f64::ModelVariant>(variant_);

    cl::Kernel normalizations = engine_.gradient_kernel("normalization_gradients");
    set_arguments(normalizations, nodes_theta_, static_cast<cl_int>(nodes_), on_device, n, variant);
    engine_.run_items(normalizations, {nodes_, 3, part.size()});
    if (interpolates_) {
      const cl::Buffer at_nodes = std::exchange(n, n_of(angles_));
      cl::Kernel interpolate = engine_.gradient_kernel("interpolate_normalizations");
      set_arguments(interpolate, at_nodes, static_cast<cl_int>(nodes_), node_first_, node_count_, node_share_,
                    static_cast<cl_int>(NormalizationNodes::width), n);
      engine_.run_items(interpolate, {angles_, 1, part.size()});
    }

    cl::Kernel gradients = engine_.gradient_kernel("log_brdf_gradients");
    set_arguments(gradients, theta_i_, theta_s_, phi_, incidence_, scatter_, n, static_cast<cl_int>(angles_),
                  share_s_, on_device, out, variant);
    engine_.queue().enqueueNDRangeKernel(gradients, cl::NullRange,
                                         {padded_ / engine_.directions_width(), part.size()}, {group, 1});
    const auto numbers = engine_.download(out, part.size() * rows * padded_);
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  return {std::move(values), padded_, pairs_};
}

}  // namespace brdftab

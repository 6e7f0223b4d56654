// ln f and its derivatives by the fourteen parameters, of many materials at one list of directions, on a
// device.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/compute/on_host/kernel_constants.hpp"
#include "host/compute/opencl/engine.hpp"
#include "host/model/direction_list.hpp"

namespace brdftab {

/// What the kernels of kernels/gradients.cl are told about a material.
template <class Constants>
Constants gradient_constants(const Parameters& parameters);

/// ln f (f in 1/sr) of materials at pairs of directions, and its derivatives by the parameters in the order
/// of parameter_table, each in its unit.
class LogBrdfValues {
 public:
  LogBrdfValues(std::vector<double> values, std::size_t padded, std::size_t pairs)
      : values_(std::move(values)), padded_(padded), pairs_(pairs) {}
  std::span<const double> ln_f(std::size_t material) const { return row(material * rows); }
  std::span<const double> by(std::size_t material, std::size_t parameter) const {
    return row(material * rows + 1 + parameter);
  }

  /// Of a list by `with_exchanges`: ln of the mean of f(i, s) and f(s, i), and its derivatives.
  LogBrdfValues mean_of_exchanges(std::size_t materials) const;

 private:
  static constexpr std::size_t rows = 1 + parameter_table.size();
  std::span<const double> row(std::size_t k) const { return std::span(values_).subspan(k * padded_, pairs_); }

  std::vector<double> values_;
  std::size_t padded_;
  std::size_t pairs_;
};

/// The pairs, and after them each with light and view exchanged.
std::vector<DirectionPair> with_exchanges(std::vector<DirectionPair> pairs);

/// Lorentzian lobes with hemispherical or reciprocal N only, which is integrated anew for each material, at
/// the nodes that NormalizationNodes has for the angles.
class LogBrdfGradients {
 public:
  /// `share_s`: the part of s-polarised light, of each pair or of all; 1/2: unpolarised. The engine must
  /// outlive this. Throws BadInput for a variant of the model that has no derivatives.
  LogBrdfGradients(const Engine& engine, std::span<const DirectionPair> pairs,
                   std::span<const double> share_s, const Variant& variant = {});
  LogBrdfGradients(const Engine& engine, std::span<const DirectionPair> pairs, double share_s,
                   const Variant& variant = {});

  std::size_t pairs() const { return pairs_; }
  LogBrdfValues evaluate(std::span<const Parameters> materials) const;

  const Watch& watch() const { return engine_.watch(); }

 private:
  const Engine& engine_;
  std::size_t pairs_;
  std::size_t padded_;
  std::size_t angles_, nodes_;
  bool interpolates_;
  Variant variant_;
  cl::Buffer nodes_theta_, node_first_, node_count_, node_share_, theta_i_, theta_s_, phi_, share_s_,
      incidence_, scatter_;
};

}  // namespace brdftab

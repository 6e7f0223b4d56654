// Seeded parameters over the whole valid ranges and their ends, and directions to try them at.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <ostream>
#include <random>
#include <string>

#include "host/model/parameters.hpp"

namespace brdftab {

class RandomMaterials {
 public:
  explicit RandomMaterials(unsigned seed) : random_(seed) {}

  double uniform(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  bool chance(double probability) { return uniform(0, 1) < probability; }

  /// One draw in six is an end of the range; the others are logarithmic, from 1e-4 where the range starts at
  /// 0.
  Parameters parameters() {
    Parameters p{};
    for (const auto& row : parameter_table) {
      const double low = row.minimum > 0 ? row.minimum : 1e-4;
      p.*row.member = chance(1. / 6) ? (chance(0.5) ? row.minimum : row.maximum)
                                     : std::exp(uniform(std::log(low), std::log(row.maximum)));
    }
    return p;
  }

  /// What a fit to paint, plastic or metal may give: every term of the model matters somewhere.
  Parameters plausible() {
    const auto around = [&](double low, double high) {
      return std::exp(uniform(std::log(low), std::log(high)));
    };
    return {.n_eff = around(0.6, 5),
            .k_eff = chance(0.5) ? 0 : around(0.01, 5),
            .sigma_surface = around(0.05, 2),
            .rho_surface = around(0.002, 3),
            .sigma_bulk = around(0.01, 2),
            .rho_bulk = around(0.1, 10),
            .sigma_retro = around(0.001, 1),
            .rho_retro = around(0.005, 3),
            .w_a = around(0.02, 2),
            .w_b = around(0.01, 5),
            .gamma = around(0.1, 30),
            .delta = around(0.05, 10),
            .w = around(0.6, 3),
            .n = chance(0.3) ? 0 : uniform(0, 40)};
  }

  Variant variant() {
    Variant s;
    s.autocovariance = chance(0.5) ? Autocovariance::lorentzian : Autocovariance::gaussian;
    const int normalization =
        static_cast<int>(uniform(0, s.autocovariance == Autocovariance::lorentzian ? 3 : 2));
    s.normalization = static_cast<Normalization>(normalization);
    s.foreshortening = chance(0.7);
    s.width_shadowing = chance(0.7);
    s.reflectance_shadowing = static_cast<ReflectanceShadowing>(static_cast<int>(uniform(0, 3)));
    return s;
  }

  double theta() { return chance(0.1) ? (chance(0.5) ? 0 : 89.9) : uniform(0, 89.9); }
  double phi() { return chance(0.2) ? 90 * std::floor(uniform(0, 5)) : uniform(0, 360); }

  std::mt19937& engine() { return random_; }

 private:
  std::mt19937 random_;
};

inline std::string text_of(const Parameters& p) {
  std::string text;
  for (const auto& row : parameter_table) text += fmt::format("{}={} ", row.name, p.*row.member);
  return text;
}

inline std::string text_of(const Variant& s) {
  return fmt::format(
      "normalization={} autocovariance={} foreshortening={} width_shadowing={} reflectance_shadowing={}",
      static_cast<int>(s.normalization), static_cast<int>(s.autocovariance), s.foreshortening,
      s.width_shadowing, static_cast<int>(s.reflectance_shadowing));
}

}  // namespace brdftab

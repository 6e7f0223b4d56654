// Hemispherical integrals of a material, on the device or by the scalar reference: N and DHR at a list of
// angles of incidence, and BHR.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/compute/normalizations.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// Directional-hemispherical reflectance by lobe and angle of incidence, and its estimated relative error.
struct Dhr {
  std::array<std::vector<double>, 3> s;
  std::array<std::vector<double>, 3> p;
  std::array<std::vector<double>, 3> error;

  double lobe(std::size_t lobe, std::size_t angle, Polarization polarization) const;
  double total(std::size_t angle, Polarization polarization) const;
  double largest_error() const;
};

struct Integrals {
  Normalizations normalization;
  Dhr dhr;
};

/// Polar angles in degrees. Throws BadInput where an integral is not finite.
Integrals integrals(const Engine& engine, const Band& band, const Variant& variant,
                    std::span<const double> theta);
Integrals reference_integrals(const Band& band, const Variant& variant, std::span<const double> theta,
                              const Watch& watch = {});

/// Bihemispherical reflectance (white-sky albedo), 2 x integral of DHR cos theta_i sin theta_i d theta_i.
struct Bhr {
  double s;
  double p;
  double error;  // relative, estimated

  double of(Polarization polarization) const;
};

Bhr bhr(const Engine& engine, const Band& band, const Variant& variant);
Bhr reference_bhr(const Band& band, const Variant& variant);

}  // namespace brdftab

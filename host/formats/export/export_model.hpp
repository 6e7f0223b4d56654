// A writer of a simulator's format is given this: a material, and its f at whatever directions the format's
// grid has.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/compute/sampled_model.hpp"
#include "host/model/colorimetry.hpp"
#include "host/model/material.hpp"

namespace brdftab {

/// What the user chooses for all simulators' formats alike.
struct ExportChoice {
  Grid grid;  // for formats whose axes are free
  Illuminant illuminant = Illuminant::d65;
  std::string history;  // time and command line
};

/// It borrows the engine.
class ExportModel {
 public:
  ExportModel(const Engine& engine, Material material, ExportChoice choice);

  const Material& material() const { return material_; }
  const Grid& grid() const { return choice_.grid; }
  Illuminant illuminant() const { return choice_.illuminant; }
  const std::string& history() const { return choice_.history; }

  std::size_t bands() const { return material_.bands().size(); }
  /// The wavelengths of the bands; empty where the material has none.
  std::vector<double> wavelengths_nm() const;

  /// Gives f in 1/sr, [band][direction], to a relative error of 1e-11 (float32 arithmetic: 1e-5). Directions
  /// are the model's; model/surface_vector.hpp makes them of vectors. Throws BadInput, which names the
  /// direction, where f is not finite.
  std::vector<std::vector<double>> evaluate(const Directions& directions,
                                            Polarization polarization = Polarization::unpolarized) const;

  /// Gives the directional-hemispherical reflectance, [band][theta_i]; theta_i is in degrees.
  std::vector<std::vector<double>> dhr(std::span<const double> theta_i,
                                       Polarization polarization = Polarization::unpolarized) const;

  /// Makes [3][sample] of [band][sample]: X, Y, Z, or linear sRGB, under the illuminant, as
  /// model/colorimetry.hpp has them.
  std::vector<std::vector<double>> xyz(const std::vector<std::vector<double>>& by_band) const;
  std::vector<std::vector<double>> rgb(const std::vector<std::vector<double>>& by_band) const;

 private:
  std::vector<std::vector<double>> values(const Directions& directions, Polarization polarization) const;

  const Engine& engine_;
  Material material_;
  ExportChoice choice_;
  mutable double sampled_to_ = 0;                  // degrees
  mutable std::unique_ptr<SampledModel> sampled_;  // once many directions are asked for
};

}  // namespace brdftab

// A file of samples at the nodes of polar angles and azimuths, read back.
#pragma once

#include <string>
#include <vector>

#include "host/export_format.hpp"
#include "host/grid_samples.hpp"

namespace brdftab {

class GridTable : public ExportedTable {
 public:
  /// At least one set of samples, of one channel or several; the channels are those of all, in order.
  GridTable(std::vector<GridSamples> samples, std::vector<double> wavelengths_nm, std::string material_text,
            std::string interpolation = "linear interpolation between nodes")
      : samples_(std::move(samples)),
        wavelengths_nm_(std::move(wavelengths_nm)),
        material_text_(std::move(material_text)),
        interpolation_(std::move(interpolation)) {}

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override {
    std::vector<std::vector<double>> f;
    for (const GridSamples& samples : samples_)
      for (auto& channel : samples.evaluate(directions)) f.push_back(std::move(channel));
    return f;
  }
  std::vector<double> wavelengths_nm() const override { return wavelengths_nm_; }
  std::string material_text() const override { return material_text_; }
  std::string interpolation() const override { return interpolation_; }
  double largest_theta_i() const override { return samples_.front().axis(AxisKind::theta_i).back(); }
  double largest_theta_s() const override { return samples_.front().axis(AxisKind::theta_s).back(); }

 private:
  std::vector<GridSamples> samples_;
  std::vector<double> wavelengths_nm_;
  std::string material_text_;
  std::string interpolation_;
};

}  // namespace brdftab

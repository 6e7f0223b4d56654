// A file of samples at the nodes of polar angles and azimuths, read back.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "host/formats/export/export_reader.hpp"
#include "host/formats/export/grid_samples.hpp"

namespace brdftab {

class GridReader : public ExportReader {
 public:
  /// `samples` has at least one set, of one channel or several; the reader's channels are those of all sets,
  /// in order.
  GridReader(std::vector<GridSamples> samples, std::vector<double> wavelengths_nm, std::string material_text,
             std::string interpolation = "linear interpolation between nodes")
      : samples_(std::move(samples)),
        wavelengths_nm_(std::move(wavelengths_nm)),
        material_text_(std::move(material_text)),
        interpolation_(std::move(interpolation)) {}

  /// Adds the same bands by one polarisation, which the file holds beside; its consumer may take them as
  /// well.
  void add_polarization(Polarization polarization, std::vector<GridSamples> samples) {
    polarized_.emplace_back(polarization, std::move(samples));
  }
  /// Says how many significant digits the file's values have, where they may be few.
  void set_digits(int digits) { digits_ = digits; }

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override;
  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override;

  std::vector<double> wavelengths_nm() const override { return wavelengths_nm_; }
  std::string material_text() const override { return material_text_; }
  std::string interpolation() const override { return interpolation_; }
  AngleRange theta_i_range() const override { return samples_.front().range(AxisKind::theta_i); }
  AngleRange theta_s_range() const override { return samples_.front().range(AxisKind::theta_s); }
  AngleRange phi_range() const override { return samples_.front().phi_range(); }

 private:
  std::vector<GridSamples> rebuilt(const std::vector<GridSamples>& held, Polarization polarization,
                                   const ExportModel& source, ValueErrors& errors) const;

  std::vector<GridSamples> samples_;
  std::vector<std::pair<Polarization, std::vector<GridSamples>>> polarized_;
  std::vector<double> wavelengths_nm_;
  std::string material_text_;
  std::string interpolation_;
  int digits_ = 17;
};

}  // namespace brdftab

#include "host/model/colorimetry.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <numeric>

#include "host/model/cie_1931.hpp"

namespace brdftab {
namespace {

// Share of band b in f at a wavelength, between the bands and beyond.
double share(const std::vector<double>& bands, std::size_t b, double wavelength) {
  const double here = bands[b];
  if (wavelength <= here) {
    if (b == 0) return 1;
    return std::max(0., 1 - (here - wavelength) / (here - bands[b - 1]));
  }
  if (b + 1 == bands.size()) return 1;
  return std::max(0., 1 - (wavelength - here) / (bands[b + 1] - here));
}

double power(const Cie1931Row& row, Illuminant illuminant) {
  return illuminant == Illuminant::d65 ? row.d65 : 1;
}

Eigen::Vector3d from_xy(double x, double y) { return {x / y, 1, (1 - x - y) / y}; }

// Columns: red, green and blue of Rec. 709, scaled to add up to its white.
Eigen::Matrix3d xyz_from_rgb(const Eigen::Vector3d& white) {
  Eigen::Matrix3d primaries;
  primaries << from_xy(0.64, 0.33), from_xy(0.30, 0.60), from_xy(0.15, 0.06);
  return primaries * primaries.inverse().operator*(white).asDiagonal();
}

// Lam's cone responses ("Bradford"), as in CIE 159:2004.
Eigen::Matrix3d adaptation(const Eigen::Vector3d& from, const Eigen::Vector3d& to) {
  Eigen::Matrix3d cones;
  cones << 0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296;
  const Eigen::Vector3d ratio = (cones * to).cwiseQuotient(cones * from);
  return cones.inverse() * ratio.asDiagonal() * cones;
}

ChannelWeights transformed(const Eigen::Matrix3d& matrix, const ChannelWeights& weights) {
  ChannelWeights result;
  for (std::size_t b = 0; b < weights[0].size(); ++b) {
    const Eigen::Vector3d channels = matrix * Eigen::Vector3d(weights[0][b], weights[1][b], weights[2][b]);
    for (std::size_t c = 0; c < 3; ++c) result[c].push_back(channels[static_cast<Eigen::Index>(c)]);
  }
  return result;
}

// Y of the perfect white is 1.
ChannelWeights tristimulus_weights(const std::vector<double>& wavelengths_nm, Illuminant illuminant) {
  const std::vector<double> bands = wavelengths_nm.empty() ? std::vector<double>{550} : wavelengths_nm;
  ChannelWeights weights;
  double white = 0;
  for (const Cie1931Row& row : cie_1931) white += row.y * power(row, illuminant);
  for (std::size_t b = 0; b < bands.size(); ++b) {
    std::array<double, 3> sum{};
    for (const Cie1931Row& row : cie_1931) {
      const double light = share(bands, b, row.wavelength_nm) * power(row, illuminant) / white;
      sum[0] += row.x * light;
      sum[1] += row.y * light;
      sum[2] += row.z * light;
    }
    for (std::size_t c = 0; c < 3; ++c) weights[c].push_back(sum[c]);
  }
  return weights;
}

// The weights of a channel add up to its value for white.
ChannelWeights relative_to_white(ChannelWeights weights) {
  for (auto& channel : weights) {
    const double sum = std::accumulate(channel.begin(), channel.end(), 0.);
    for (double& weight : channel) weight /= sum;
  }
  return weights;
}

}  // namespace

ChannelWeights xyz_weights(const std::vector<double>& wavelengths_nm, Illuminant illuminant) {
  return relative_to_white(tristimulus_weights(wavelengths_nm, illuminant));
}

ChannelWeights rgb_weights(const std::vector<double>& wavelengths_nm, Illuminant illuminant) {
  const ChannelWeights white = tristimulus_weights({}, illuminant);
  const Eigen::Vector3d seen(white[0][0], white[1][0], white[2][0]);
  const Eigen::Vector3d srgb_white = from_xy(0.3127, 0.3290);
  // White has three ones but for rounding; grey is to be exact.
  return relative_to_white(transformed(xyz_from_rgb(srgb_white).inverse() * adaptation(seen, srgb_white),
                                       tristimulus_weights(wavelengths_nm, illuminant)));
}

std::string_view rgb_convention(Illuminant illuminant) {
  return illuminant == Illuminant::d65
             ? "linear sRGB (Rec. 709) by the CIE 1931 2-degree observer under D65; f linear between bands, "
               "constant beyond"
             : "linear sRGB (Rec. 709) by the CIE 1931 2-degree observer under equal energy, "
               "Bradford-adapted to D65; f linear between bands, constant beyond";
}

std::vector<std::vector<double>> weighted(const ChannelWeights& weights,
                                          const std::vector<std::vector<double>>& by_band) {
  std::vector<std::vector<double>> channels(3, std::vector<double>(by_band.front().size()));
  for (std::size_t c = 0; c < 3; ++c)
    for (std::size_t b = 0; b < by_band.size(); ++b)
      for (std::size_t k = 0; k < by_band[b].size(); ++k) channels[c][k] += weights[c][b] * by_band[b][k];
  return channels;
}

}  // namespace brdftab

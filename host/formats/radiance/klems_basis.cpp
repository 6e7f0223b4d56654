#include "host/formats/radiance/klems_basis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>

#include "host/base/angle.hpp"

namespace brdftab {
namespace {

constexpr double step_theta_i = 1, step_theta_s = 0.5;
constexpr std::size_t azimuths = 181;

struct PolarNode {
  double theta;
  double weight;  // of its band; they add up to 1
};

double sin2(double theta) { return std::pow(std::sin(radians(theta)), 2); }

std::vector<PolarNode> polar_nodes(const KlemsBand& band, double step) {
  const double count = std::ceil((band.last - band.first) / step), width = (band.last - band.first) / count;
  std::vector<PolarNode> nodes;
  for (double k = 0; k < count; ++k) {
    const double first = band.first + k * width;
    nodes.push_back(
        {first + width / 2, (sin2(first + width) - sin2(first)) / (sin2(band.last) - sin2(band.first))});
  }
  return nodes;
}

// The azimuths go from 0 to 180 degrees; their spacing grows with the square of the distance from both ends.
std::vector<double> graded_azimuths() {
  std::vector<double> phi;
  for (std::size_t k = 0; k < azimuths; ++k) {
    const double turn = static_cast<double>(k) / static_cast<double>(azimuths - 1);
    phi.push_back(180 * (turn - std::sin(2 * std::numbers::pi * turn) / (2 * std::numbers::pi)));
  }
  phi.front() = 0;
  phi.back() = 180;
  return phi;
}

// A function of the azimuth is even, has a period of 360 degrees, and is linear between nodes. Its averages
// come from the second antiderivative of its deviation from the mean, which is even and periodic too.
class EvenAzimuth {
 public:
  EvenAzimuth(const std::vector<double>& phi, const double* values)
      : phi_(phi), deviation_(values, values + phi.size()) {
    double sum = 0;
    for (std::size_t k = 0; k + 1 < phi.size(); ++k)
      sum += (phi[k + 1] - phi[k]) * (values[k] + values[k + 1]) / 2;
    mean_ = sum / 180;
    for (double& value : deviation_) value -= mean_;
    first_.assign(phi.size(), 0);
    second_.assign(phi.size(), 0);
    for (std::size_t k = 0; k + 1 < phi.size(); ++k) {
      const double h = phi[k + 1] - phi[k];
      first_[k + 1] = first_[k] + h * (deviation_[k] + deviation_[k + 1]) / 2;
      second_[k + 1] = second_[k] + h * first_[k] + h * h * (2 * deviation_[k] + deviation_[k + 1]) / 6;
    }
  }

  /// Gives the mean over two azimuths, each uniform over a width, whose centres are `difference` apart;
  /// degrees.
  double average(double difference, double width_i, double width_s) const {
    const double outer = (width_i + width_s) / 2, inner = (width_i - width_s) / 2;
    return mean_ + (second_integral(difference + outer) - second_integral(difference + inner) -
                    second_integral(difference - inner) + second_integral(difference - outer)) /
                       (width_i * width_s);
  }

 private:
  double second_integral(double phi) const {
    const double at = std::abs(std::remainder(phi, 360));
    const auto above = std::upper_bound(phi_.begin() + 1, phi_.end() - 1, at);
    const auto k = static_cast<std::size_t>(above - phi_.begin()) - 1;
    const double x = at - phi_[k], slope = (deviation_[k + 1] - deviation_[k]) / (phi_[k + 1] - phi_[k]);
    return second_[k] + x * (first_[k] + x * (deviation_[k] / 2 + x * slope / 6));
  }

  const std::vector<double>& phi_;
  std::vector<double> deviation_, first_, second_;
  double mean_;
};

// Gives phi_s - phi_i of two patches, in units of 360 degrees / (patches_i patches_s), from 0 to half a turn.
int azimuth_difference(const KlemsBand& in, int k_i, const KlemsBand& out, int k_s) {
  const int turn = in.patches * out.patches;
  const int difference = ((k_s * in.patches - k_i * out.patches) % turn + turn) % turn;
  return std::min(difference, turn - difference);
}

double degrees_of(int difference, const KlemsBand& in, const KlemsBand& out) {
  return 360.0 * difference / (in.patches * out.patches);
}

std::vector<int> azimuth_differences(const KlemsBand& in, const KlemsBand& out) {
  std::vector<int> all;
  for (int i = 0; i < in.patches; ++i)
    for (int s = 0; s < out.patches; ++s) all.push_back(azimuth_difference(in, i, out, s));
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

// For one band of patches of incidence and one of scatter: [band of the material] by difference of azimuth.
using PairValues = std::map<int, std::vector<double>>;

PairValues averages(const ExportModel& source, const KlemsBand& in, const KlemsBand& out) {
  static const std::vector<double> phi = graded_azimuths();
  const auto nodes_i = polar_nodes(in, step_theta_i), nodes_s = polar_nodes(out, step_theta_s);
  Directions directions;
  for (const PolarNode& i : nodes_i)
    for (const PolarNode& s : nodes_s)
      for (const double azimuth : phi) directions.add(i.theta, s.theta, azimuth);
  const auto f = source.evaluate(directions);
  PairValues result;
  const auto differences = azimuth_differences(in, out);
  for (const int difference : differences) result[difference].assign(f.size(), 0);
  for (std::size_t band = 0; band < f.size(); ++band) {
    const double* row = f[band].data();
    for (const PolarNode& i : nodes_i)
      for (const PolarNode& s : nodes_s) {
        const EvenAzimuth over_azimuth(phi, row);
        row += phi.size();
        for (const int difference : differences)
          result[difference][band] +=
              i.weight * s.weight *
              over_azimuth.average(degrees_of(difference, in, out), in.width(), out.width());
      }
  }
  return result;
}

PairValues centres(const ExportModel& source, const KlemsBand& in, const KlemsBand& out) {
  const auto differences = azimuth_differences(in, out);
  Directions directions;
  for (const int difference : differences)
    directions.add(in.centre, out.centre, degrees_of(difference, in, out));
  const auto f = source.evaluate(directions);
  PairValues result;
  for (std::size_t k = 0; k < differences.size(); ++k)
    for (const auto& band : f) result[differences[k]].push_back(band[k]);
  return result;
}

}  // namespace

std::size_t first_patch(std::size_t band) {
  std::size_t patch = 0;
  for (std::size_t b = 0; b < band; ++b) patch += static_cast<std::size_t>(klems_bands[b].patches);
  return patch;
}

std::size_t klems_patch(double theta, double phi) {
  std::size_t band = 0;
  while (band + 1 < klems_bands.size() && theta >= klems_bands[band].last) ++band;
  const int patches = klems_bands[band].patches;
  const int nearest = static_cast<int>(std::lround(phi / klems_bands[band].width())) % patches;
  return first_patch(band) + static_cast<std::size_t>((nearest + patches) % patches);
}

std::vector<std::vector<double>> klems_matrix(const ExportModel& source, PatchValue value) {
  std::vector<std::vector<double>> matrix(source.bands(), std::vector<double>(klems_patches * klems_patches));
  for (std::size_t i = 0; i < klems_bands.size(); ++i)
    for (std::size_t s = 0; s < klems_bands.size(); ++s) {
      const KlemsBand &in = klems_bands[i], &out = klems_bands[s];
      const PairValues values =
          value == PatchValue::average ? averages(source, in, out) : centres(source, in, out);
      for (int k_s = 0; k_s < out.patches; ++k_s)
        for (int k_i = 0; k_i < in.patches; ++k_i) {
          const auto& bands = values.at(azimuth_difference(in, k_i, out, k_s));
          const std::size_t row = first_patch(s) + static_cast<std::size_t>(k_s);
          for (std::size_t band = 0; band < bands.size(); ++band)
            matrix[band][row * klems_patches + first_patch(i) + static_cast<std::size_t>(k_i)] = bands[band];
        }
    }
  return matrix;
}

}  // namespace brdftab

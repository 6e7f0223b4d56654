#include "host/formats/export/export_directions.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "host/base/angle.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

// A file may go to 90 degrees; the model stops short of them.
constexpr double largest_theta = 89.9;
constexpr double nearest_log = -3, furthest = 30;
// A file may have samples in small parts of its ranges, so that many draws are in vain.
constexpr std::size_t most_tries = 100;

AngleRange within_model(AngleRange range) {
  return {std::min(range.first, largest_theta), std::min(range.last, largest_theta)};
}

double cosine(double degrees) { return std::cos(degrees / degrees_per_radian); }

class Draw {
 public:
  explicit Draw(const ExportReader& table)
      : table_(table),
        theta_i_(within_model(table.theta_i_range())),
        theta_s_(within_model(table.theta_s_range())),
        phi_(table.phi_range()) {}

  ExportDirections all(std::size_t count) {
    ExportDirections result{{}, {}, {}, theta_i_, theta_s_, phi_, 0};
    std::size_t tries = 0;
    for (; result.uniform.size() < count && tries < most_tries * count; ++tries) {
      const double theta_i = theta(theta_i_), theta_s = theta(theta_s_);
      add_covered(result.uniform, theta_i, theta_s, between(phi_.first, phi_.last));
    }
    const double covered =
        tries > 0 ? static_cast<double>(result.uniform.size()) / static_cast<double>(tries) : 0;
    result.share = covered * solid_angle(theta_i_) * solid_angle(theta_s_) * (phi_.last - phi_.first) / 360;
    for (tries = 0;
         result.near_mirror.size() + result.near_retro.size() < count && tries < most_tries * count; ++tries)
      tries % 2 ? add_near(result.near_retro, 180) : add_near(result.near_mirror, 0);
    return result;
  }

 private:
  double between(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  double theta(AngleRange range) {
    if (range.first == range.last) return range.first;
    return degrees(std::acos(between(cosine(range.last), cosine(range.first))));
  }
  /// Gives the share of the hemisphere that a range of polar angles has.
  static double solid_angle(AngleRange range) { return cosine(range.first) - cosine(range.last); }

  void add_covered(Directions& directions, double theta_i, double theta_s, double phi) const {
    directions.add(theta_i, theta_s, phi);
    if (table_.covers(directions, directions.size() - 1)) return;
    for (auto* angles : {&directions.theta_i, &directions.theta_s, &directions.phi}) angles->pop_back();
  }

  /// Gives the azimuth nearest to `phi` that has samples.
  double nearest_phi(double phi) const {
    if (phi_.last - phi_.first >= 360) return phi;
    const double middle = (phi_.first + phi_.last) / 2, half = (phi_.last - phi_.first) / 2;
    return middle + std::clamp(std::remainder(phi - middle, 360), -half, half);
  }

  // Adds a pair whose scattered direction lies about that at theta_s = theta_i and azimuth `phi`.
  void add_near(Directions& directions, double phi) {
    const double last = std::max(std::min(theta_i_.last, theta_s_.last), theta_i_.first);
    const double theta_i = theta({theta_i_.first, last});
    const double distance = std::pow(10, between(nearest_log, std::log10(furthest)));
    const SurfaceVector drawn = about_specular(theta_i, distance, between(-180, 180));
    const double theta_s = std::clamp(drawn.theta(), theta_s_.first, theta_s_.last),
                 azimuth = nearest_phi(drawn.phi() + phi);
    const double to_peak =
        SurfaceVector::from_degrees(theta_i, phi).dot(SurfaceVector::from_degrees(theta_s, azimuth));
    if (to_peak > cosine(furthest)) add_covered(directions, theta_i, theta_s, azimuth);
  }

  const ExportReader& table_;
  AngleRange theta_i_, theta_s_, phi_;
  std::mt19937_64 random_{20'080'818};
};

}  // namespace

ExportDirections export_directions(const ExportReader& table, std::size_t count) {
  return Draw(table).all(count);
}

}  // namespace brdftab

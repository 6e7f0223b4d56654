#include "host/pictures/in_plane.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/numbers.hpp"
#include "host/pictures/drawing/smooth_curve.hpp"

namespace brdftab {
namespace {

constexpr double nearly_in_plane = 3;  // degrees
constexpr double nearly_normal = 0.1;  // degrees
constexpr double outermost = 89.9;     // degrees

}  // namespace

std::optional<double> in_plane_theta_s(const DirectionPair& pair) {
  const double phi = std::remainder(pair.model_phi(), 360);
  if (pair.model_theta_s() <= nearly_normal || std::abs(phi) <= nearly_in_plane) return pair.model_theta_s();
  if (180 - std::abs(phi) <= nearly_in_plane) return -pair.model_theta_s();
  return std::nullopt;
}

std::vector<InPlaneScan> in_plane_scans(std::span<const MeasuredSample> samples,
                                        const Incidences& incidences) {
  std::vector<InPlaneScan> scans;
  for (const double theta_i : incidences.angles()) scans.push_back({theta_i, {}});
  for (const MeasuredSample& sample : samples)
    if (const auto theta_s = in_plane_theta_s(sample.pair); theta_s && sample.brdf > 0)
      scans[incidences.index(sample.pair.theta_i)].points.push_back({*theta_s, sample.brdf});
  std::erase_if(scans, [](const InPlaneScan& scan) { return scan.points.empty(); });
  return scans;
}

std::string not_drawn_note(std::span<const MeasuredSample> samples) {
  const auto count = std::count_if(samples.begin(), samples.end(), [](const MeasuredSample& sample) {
    return !(sample.brdf > 0) && in_plane_theta_s(sample.pair).has_value();
  });
  return count > 0 ? fmt::format("not drawn: {} at or below 0", count) : "";
}

drawing::ChartAxis theta_s_axis() {
  return {"scatter angle θ_s (degrees; forward side positive)", -90, 90, false, 30};
}

drawing::ChartAxis narrow_theta_s_axis() { return {"θ_s (degrees)", -90, 90, false, 30}; }

std::string incidence_label(double theta_i) { return shortest(theta_i) + "°"; }

std::string incidence_label(double first, double last) {
  return first == last ? incidence_label(first) : shortest(first) + " to " + incidence_label(last);
}

std::vector<std::vector<drawing::ChartPoint>> in_plane_curves(std::span<const double> theta_i,
                                                              const BrdfAt& brdf) {
  std::vector<std::vector<double>> starts;
  for (const double angle : theta_i) {
    const double peaks[] = {0, angle, -angle};
    starts.push_back(drawing::curve_starts(-outermost, outermost, 1, peaks));
  }
  return drawing::smooth_curves(
      starts,
      [&](std::span<const drawing::CurvePlace> places) {
        std::vector<DirectionPair> pairs;
        for (const drawing::CurvePlace& place : places)
          pairs.push_back({theta_i[place.curve], place.x, 0, 0});
        return brdf(pairs);
      },
      true);
}

}  // namespace brdftab

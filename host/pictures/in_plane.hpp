// Directions in the plane of incidence: theta_s with the sign of its side, forward positive.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/model/direction_list.hpp"
#include "host/model/measurement/measurement.hpp"
#include "host/pictures/drawing/chart.hpp"

namespace brdftab {

inline constexpr const char* brdf_axis_label = "BRDF f_r (sr^{−1})";
inline constexpr double usual_incidences[] = {0,  10, 20, 30, 40,
                                              50, 60, 70, 80};  // degrees, as the paper's Fig. 3

/// Signed theta_s of a sample, where it is within 3 degrees of azimuth of the plane, or within 0.1 degrees of
/// the normal.
std::optional<double> in_plane_theta_s(const DirectionPair& pair);

/// What was measured in plane at one setting of theta_i, degrees: f over the signed theta_s.
struct InPlaneScan {
  double theta_i;
  std::vector<ChartPoint> points;
};

/// By increasing theta_i; the samples' angles are among those of `incidences`. Readings at or below 0, which
/// noise makes, have no place on a logarithmic axis: they are left out.
std::vector<InPlaneScan> in_plane_scans(std::span<const MeasuredSample> samples,
                                        const Incidences& incidences);

/// For a chart: how many readings in plane are left out for that; empty where none are.
std::string not_drawn_note(std::span<const MeasuredSample> samples);

/// -90 to 90 degrees; with a short name for panels beside each other.
ChartAxis theta_s_axis();
ChartAxis narrow_theta_s_axis();

/// An entry of a legend; of several settings together their first and last.
std::string incidence_label(double theta_i);
std::string incidence_label(double first, double last);

/// f at directions, in 1/sr.
using BrdfAt = std::function<std::vector<double>(std::span<const DirectionPair>)>;

/// A smooth curve of f over theta_s from -89.9 to 89.9 degrees for each theta_i, for a logarithmic axis.
std::vector<std::vector<ChartPoint>> in_plane_curves(std::span<const double> theta_i, const BrdfAt& brdf);

}  // namespace brdftab

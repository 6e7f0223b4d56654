// The plane of incidence: theta_s there is positive on the forward side and negative on the backward side.
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
/// The angles of incidence in degrees of the paper's Fig. 3.
inline constexpr double usual_incidences[] = {0, 10, 20, 30, 40, 50, 60, 70, 80};

/// The signed theta_s in degrees of a direction whose azimuth is within 3 degrees of the plane, or which is
/// within 0.1 degrees of the normal; none for other directions.
std::optional<double> in_plane_theta_s(const DirectionPair& pair);

/// What was measured in the plane of incidence at one setting of theta_i.
struct InPlaneScan {
  double theta_i;                           // degrees
  std::vector<drawing::ChartPoint> points;  // f in 1/sr over the signed theta_s in degrees
};

/// The scans of a measurement in the order of increasing theta_i. The samples' angles of incidence have to be
/// among `incidences`. Readings at or below 0, which noise makes, are left out: a logarithmic axis has no
/// place for them.
std::vector<InPlaneScan> in_plane_scans(std::span<const MeasuredSample> samples,
                                        const Incidences& incidences);

/// A chart's note that says how many readings in the plane of incidence are at or below 0; empty where none
/// is.
std::string not_drawn_note(std::span<const MeasuredSample> samples);

/// The axis of theta_s from -90 to 90 degrees. The narrow one has a short name for panels beside each other.
drawing::ChartAxis theta_s_axis();
drawing::ChartAxis narrow_theta_s_axis();

/// The legend's text for one theta_i in degrees, or for several settings from the first to the last.
std::string incidence_label(double theta_i);
std::string incidence_label(double first, double last);

/// f in 1/sr at each of some directions.
using BrdfAt = std::function<std::vector<double>(std::span<const DirectionPair>)>;

/// For each theta_i in degrees, a curve of f over theta_s from -89.9 to 89.9 degrees that looks smooth on a
/// logarithmic axis.
std::vector<std::vector<drawing::ChartPoint>> in_plane_curves(std::span<const double> theta_i,
                                                              const BrdfAt& brdf);

}  // namespace brdftab

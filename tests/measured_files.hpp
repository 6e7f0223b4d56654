// The same measurement in every layout, as other people's programs write it.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

namespace brdftab {

inline constexpr double radian = std::numbers::pi / 180;

// A surface that is reciprocal and reflects less than it gets: a diffuse part and a lobe about the mirror
// direction.
struct Surface {
  double albedo = 0.4, peak = 0.8, width = 0.25;
  double operator()(double theta_i, double theta_s, double phi) const {
    const double a = std::sin(theta_s * radian) * std::cos(phi * radian) - std::sin(theta_i * radian);
    const double b = std::sin(theta_s * radian) * std::sin(phi * radian);
    return albedo / std::numbers::pi + peak / (1 + (a * a + b * b) / (width * width));
  }
};

struct Row {
  double theta_i, theta_s, phi, brdf;  // degrees, phi = 0 forward
};

using Change = std::function<double(double brdf, double theta_s)>;

inline std::vector<Row> in_plane(const Surface& f, double step_i = 15, double step_s = 5) {
  std::vector<Row> rows;
  for (double i = 0; i <= 75; i += step_i)
    for (double s = -80; s <= 80; s += step_s)
      rows.push_back({i, std::abs(s), s < 0 ? 180. : 0., f(i, std::abs(s), s < 0 ? 180 : 0)});
  return rows;
}

inline std::vector<Row> one_view(const Surface& f, double theta_s = 0) {
  std::vector<Row> rows;
  for (double i = 0; i <= 80; i += 2) rows.push_back({i, theta_s, 0, f(i, theta_s, 0)});
  return rows;
}

inline double as_is(double brdf, double) { return brdf; }

inline std::string csv(const std::vector<Row>& rows, const Change& change = as_is, double angle = 1,
                       double azimuth = 1) {
  std::string text = "theta_i_deg,theta_s_deg,phi_deg,brdf_per_sr\n";
  for (const Row& r : rows)
    text += fmt::format("{:.8f},{:.8f},{:.8f},{:.17g}\n", r.theta_i * angle, r.theta_s * angle,
                        r.phi * azimuth, change(r.brdf, r.theta_s));
  return text;
}

inline std::string alta(const std::vector<Row>& rows, const Change& change = as_is, double angle = radian) {
  std::string text = "#DIM 4 1\n#PARAM_IN SPHERICAL_TL_PL_TV_PV\n#PARAM_OUT INV_STERADIAN\n";
  for (const Row& r : rows)
    text += fmt::format("{:.9f} 0 {:.9f} {:.9f} {:.17g}\n", r.theta_i * angle, r.theta_s * angle,
                        (r.phi + 180) * angle, change(r.brdf, r.theta_s));
  return text;
}

inline std::string astm(const std::vector<Row>& rows, const Change& change = as_is, double angle = radian,
                        const std::string& channels = "550nm", std::size_t said = 0) {
  std::string text = fmt::format("NUM_POINTS {}\nVARS theta_i,phi_i,theta_s,phi_s,{}\n",
                                 said ? said : rows.size(), channels);
  for (const Row& r : rows) {
    text +=
        fmt::format("{:.9f},0,{:.9f},{:.9f}", r.theta_i * angle, r.theta_s * angle, (r.phi + 180) * angle);
    for (long k = std::count(channels.begin(), channels.end(), ','); k >= 0; --k)
      text += fmt::format(",{:.17g}", change(r.brdf, r.theta_s) * (1 + 0.1 * static_cast<double>(k)));
    text += "\n";
  }
  return text;
}

// The layout counts angles about the specular direction. Radial angles lie in the plane only, where signed
// theta_s is theta_i -+ radial.
inline std::string zemax(const Surface& f, const Change& change = as_is, double angle = 1) {
  const std::vector<double> incidence{10, 40, 60}, azimuth{0, 180},
      radial{0, 5, 10, 20, 30, 40, 50, 60, 80, 110};
  const auto list = [&](const char* key, const std::vector<double>& axis) {
    std::string text = fmt::format("{} {}\n", key, axis.size());
    for (const double a : axis) text += fmt::format("{:.9f} ", a * angle);
    return text + "\n";
  };
  std::string text =
      "Source Measured\nSymmetry PlaneSymmetrical\nSpectralContent Monochrome\nScatterType "
      "BRDF\nSampleRotation 1\n0\n";
  text +=
      list("AngleOfIncidence", incidence) + list("ScatterAzimuth", azimuth) + list("ScatterRadial", radial);
  text += "Monochrome\nDataBegin\n";
  for (const double i : incidence) {
    text += "TIS 0.5\n";
    for (const double a : azimuth) {
      for (const double r : radial) {
        const double s = a == 0 ? i - r : i + r;
        const bool above = std::abs(s) < 90;
        text += fmt::format("{:.17g} ", above ? change(f(i, std::abs(s), s < 0 ? 180 : 0), std::abs(s)) : 0);
      }
      text += "\n";
    }
  }
  return text + "DataEnd\n";
}

}  // namespace brdftab

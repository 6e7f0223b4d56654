#include "host/pictures/angles_sketch.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>

#include "host/base/angle.hpp"
#include "host/pictures/drawing/svg.hpp"

namespace brdftab {
namespace {

constexpr double theta_i = 42, theta_s = 60, phi = 58;
constexpr drawing::Ink incident_ink{{0xd5, 0x5e, 0x00}, {0xf0, 0x80, 0x30}};
constexpr drawing::Ink scattered_ink{{0x00, 0x72, 0xb2}, {0x4d, 0xa6, 0xe0}};

struct Point {
  double x, y;
};

// Where a point in space is seen on the page: x points to the forward side, y away from the reader, z along
// the normal.
Point seen(double x, double y, double z) {
  return {260 + 150 * (x - 0.22 * y), 214 - 150 * (0.96 * z + 0.34 * y)};
}

// The point at a distance from the origin in a direction given in degrees.
Point along(double theta, double azimuth, double length) {
  return seen(length * std::sin(radians(theta)) * std::cos(radians(azimuth)),
              length * std::sin(radians(theta)) * std::sin(radians(azimuth)),
              length * std::cos(radians(theta)));
}

// The path of a curve with a parameter between two values.
std::string curve(double from, double to, const std::function<Point(double)>& at) {
  std::string d;
  for (int k = 0; k <= 48; ++k) {
    const Point p = at(from + (to - from) * k / 48);
    d += fmt::format("{}{:.1f} {:.1f}", k ? "L" : "M", p.x, p.y);
  }
  return d;
}

void arrow(drawing::Svg& svg, const Point& from, const Point& to, const drawing::Ink& ink, double width,
           std::string_view dash = "") {
  const double length = std::hypot(to.x - from.x, to.y - from.y);
  const double ux = (to.x - from.x) / length, uy = (to.y - from.y) / length;
  svg.line(from.x, from.y, to.x - 4 * ux, to.y - 4 * uy, ink, width, dash);
  svg.path(fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}L{:.1f} {:.1f}", to.x - 9 * ux + 4 * uy,
                       to.y - 9 * uy - 4 * ux, to.x, to.y, to.x - 9 * ux - 4 * uy, to.y - 9 * uy + 4 * ux),
           ink, width, "", "stroke-linejoin=\"round\" stroke-linecap=\"round\"");
}

}  // namespace

std::string angles_sketch() {
  drawing::Svg svg(520, 296);
  const Point origin = seen(0, 0, 0);
  svg.path(curve(0, 360, [](double azimuth) { return along(90, azimuth, 1.12); }) + "Z", drawing::inks::frame,
           1);
  svg.path(curve(0, phi, [](double azimuth) { return along(90, azimuth, 0.5); }), drawing::inks::text, 1.2);
  const Point forward = along(90, 0, 1.35), backward = along(90, 180, 1.35), top = along(0, 0, 1.3);
  svg.line(backward.x, backward.y, forward.x, forward.y, drawing::inks::frame, 1, "4 3");
  arrow(svg, origin, top, drawing::inks::frame, 1.2);
  const Point source = along(theta_i, 180, 1.3), mirror = along(theta_i, 0, 1.2),
              out = along(theta_s, phi, 1.35);
  const Point foot = along(90, phi, 1.35 * std::sin(radians(theta_s)));
  arrow(svg, source, origin, incident_ink, 2.4);
  arrow(svg, origin, mirror, incident_ink, 1.4, "6 4");
  arrow(svg, origin, out, scattered_ink, 2.4);
  svg.line(origin.x, origin.y, foot.x, foot.y, scattered_ink, 1, "3 3");
  svg.line(foot.x, foot.y, out.x, out.y, scattered_ink, 1, "3 3");
  svg.path(curve(0, theta_i, [](double theta) { return along(theta, 180, 0.62); }), incident_ink, 1.4);
  svg.path(curve(0, theta_s, [](double theta) { return along(theta, phi, 0.62); }), scattered_ink, 1.4);
  const auto label = [&](const Point& at, double dx, double dy, std::string_view text, const char* anchor,
                         const drawing::Ink& ink) {
    svg.text(at.x + dx, at.y + dy, text, {.anchor = anchor, .size = 13.5, .ink = ink});
  };
  label(along(theta_i / 2, 180, 0.62), -3, -8, "θ_i", "middle", incident_ink);
  label(along(theta_s / 2, phi, 0.62), 2, -9, "θ_s", "middle", scattered_ink);
  label(along(90, 0.3 * phi, 0.5), 10, 0, "φ", "start", drawing::inks::text);
  label(top, 0, -6, "normal", "middle", drawing::inks::text);
  label(source, 4, -8, "light comes in", "end", incident_ink);
  label(mirror, 8, 4, "mirror direction", "start", incident_ink);
  label(out, 6, -6, "scattered", "start", scattered_ink);
  label(forward, -6, 20, "φ = 0, forward", "middle", drawing::inks::text);
  label(backward, 10, 20, "φ = 180°, retro", "middle", drawing::inks::text);
  return svg.document(
      "The angles: theta_i and theta_s from the normal, phi = phi_s − phi_i from the forward side");
}

}  // namespace brdftab

#include "host/compute/integrals.hpp"

#include <boost/math/quadrature/gauss_kronrod.hpp>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "host/reference/model.hpp"

namespace brdftab {
namespace {

double of(double s, double p, Polarization polarization) {
  return polarization == Polarization::s ? s : polarization == Polarization::p ? p : 0.5 * (s + p);
}

Dhr device_dhr(const Engine& engine, const Band& band, const Variant& variant, std::span<const double> theta,
               const Normalizations& n) {
  const std::size_t bytes = 3 * theta.size() * bytes_of(engine.working());
  const std::array buffers{engine.buffer(bytes), engine.buffer(bytes), engine.buffer(bytes)};
  const cl::Buffer angles = engine.upload_polar_angles(theta);
  cl::Kernel kernel = engine.kernel("dhrs");
  set_arguments(kernel, angles, static_cast<cl_int>(theta.size()), n.on_device, buffers[0], buffers[1],
                buffers[2]);
  KernelMaterial(band.parameters, variant, engine.working()).set(kernel, 6);
  run_by_angle(engine, kernel, theta.size());
  Dhr dhr{download_by_lobe(engine, buffers[0], theta.size()),
          download_by_lobe(engine, buffers[1], theta.size()),
          download_by_lobe(engine, buffers[2], theta.size())};
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    for (std::size_t k = 0; k < theta.size(); ++k)
      if (!std::isfinite(dhr.lobe(lobe, k, Polarization::unpolarized)) || !std::isfinite(dhr.error[lobe][k]))
        refuse_not_finite("DHR", lobe, theta[k], band.parameters);
  return dhr;
}

// A piece of a segment of theta_i, whose ends are where DHR may bend: theta = begin + (end - begin) z^2 (3 -
// 2z) makes square roots there smooth.
struct Panel {
  double segment_begin, segment_end;  // degrees
  double begin, end;                  // of z in [0, 1]
  double s = 0, p = 0;
  double error = 0;  // absolute, of s + p

  double theta(double z) const { return segment_begin + (segment_end - segment_begin) * z * z * (3 - 2 * z); }
  double theta_per_z(double z) const { return (segment_end - segment_begin) * 6 * z * (1 - z); }
};

// sqrt(R_p) has a kink at the Brewster angle, and R a square root at the critical angle: where
// |(m^2 + 1) cos^2 - 1| is least, and where Re(m^2 - sin^2) = 0.
std::vector<Panel> first_panels(const Parameters& parameters) {
  const std::complex<double> m2 = std::pow(std::complex<double>(parameters.n_eff, parameters.k_eff), 2);
  std::vector<double> stops{0, 90};
  for (const double sine2 : {1 - (1.0 / (m2 + 1.0)).real(), m2.real()})
    if (sine2 > 0 && sine2 < 1) stops.push_back(std::asin(std::sqrt(sine2)) * 180 / std::numbers::pi);
  std::sort(stops.begin(), stops.end());
  std::vector<Panel> panels;
  for (std::size_t k = 1; k < stops.size(); ++k)
    if (stops[k] > stops[k - 1])
      for (const double half : {0.0, 0.5}) panels.push_back({stops[k - 1], stops[k], half, half + 0.5});
  return panels;
}

using Rule = boost::math::quadrature::gauss_kronrod<double, 15>;
using GaussRule = boost::math::quadrature::gauss<double, 7>;

// The rule's nodes over (-1, 1) with both weights; Boost stores the half with x >= 0, zero first.
struct RuleNode {
  double x, kronrod, gauss;
};

std::vector<RuleNode> rule_nodes() {
  std::vector<RuleNode> nodes;
  for (std::size_t k = 0; k < Rule::abscissa().size(); ++k) {
    const double x = Rule::abscissa()[k];
    double gauss = 0;
    for (std::size_t j = 0; j < GaussRule::abscissa().size(); ++j)
      if (std::abs(GaussRule::abscissa()[j] - x) < 1e-12) gauss = GaussRule::weights()[j];
    nodes.push_back({x, Rule::weights()[k], gauss});
    if (x != 0) nodes.push_back({-x, Rule::weights()[k], gauss});
  }
  return nodes;
}

// All nodes of several panels go to the device at once.
void integrate_panels(const Engine& engine, const Band& band, const Variant& variant,
                      std::span<Panel> panels) {
  static const std::vector<RuleNode> nodes = rule_nodes();
  std::vector<double> theta;
  for (const Panel& panel : panels)
    for (const RuleNode& node : nodes)
      theta.push_back(panel.theta(panel.begin + (panel.end - panel.begin) * 0.5 * (1 + node.x)));
  const Integrals at = integrals(engine, band, variant, theta);
  std::size_t k = 0;
  for (Panel& panel : panels) {
    double gauss = 0;
    for (const RuleNode& node : nodes) {
      const double z = panel.begin + (panel.end - panel.begin) * 0.5 * (1 + node.x);
      // 2 cos sin = sin 2 theta; d theta in radians.
      const double weight = std::sin(theta[k] * std::numbers::pi / 90) * panel.theta_per_z(z) *
                            std::numbers::pi / 180 * 0.5 * (panel.end - panel.begin);
      const double s = at.dhr.total(k, Polarization::s);
      const double p = at.dhr.total(k, Polarization::p);
      panel.s += node.kronrod * weight * s;
      panel.p += node.kronrod * weight * p;
      gauss += node.gauss * weight * (s + p);
      ++k;
    }
    // As QUADPACK estimates the error of the finer rule, and as kernels/quadrature.h does.
    const double value = panel.s + panel.p;
    const double difference = std::abs(value - gauss);
    if (value > 0)
      panel.error =
          std::min(difference, std::max(value * std::pow(200 * difference / value, 1.5), 0.01 * difference));
  }
}

// Relative, of a panel by its estimate, which is far above its error: 5e-10 at most on the shipped materials.
constexpr double bhr_tolerance = 1e-5;
constexpr int bhr_rounds = 12;

}  // namespace

double Dhr::lobe(std::size_t lobe, std::size_t angle, Polarization polarization) const {
  return of(s[lobe][angle], p[lobe][angle], polarization);
}

double Dhr::total(std::size_t angle, Polarization polarization) const {
  return lobe(0, angle, polarization) + lobe(1, angle, polarization) + lobe(2, angle, polarization);
}

double Dhr::largest_error() const {
  double largest = 0;
  for (const auto& errors : error)
    for (const double e : errors) largest = std::max(largest, e);
  return largest;
}

double Bhr::of(Polarization polarization) const { return brdftab::of(s, p, polarization); }

Integrals integrals(const Engine& engine, const Band& band, const Variant& variant,
                    std::span<const double> theta) {
  Normalizations n = normalizations(engine, band, variant, theta);
  Dhr dhr = device_dhr(engine, band, variant, theta, n);
  return {std::move(n), std::move(dhr)};
}

Integrals reference_integrals(const Band& band, const Variant& variant, std::span<const double> theta,
                              const Watch& watch) {
  const reference::Model model(band.parameters, variant);
  Integrals result;
  for (const double angle : theta) {
    watch.stop_if_asked();
    const auto dhr = model.dhr(angle);
    const std::array s{dhr.s.surface, dhr.s.bulk, dhr.s.retro};
    const std::array p{dhr.p.surface, dhr.p.bulk, dhr.p.retro};
    for (std::size_t lobe = 0; lobe < 3; ++lobe) {
      const auto n = model.normalization(static_cast<Lobe>(lobe), angle);
      result.normalization.value[lobe].push_back(n.value);
      result.normalization.error[lobe].push_back(n.error);
      result.dhr.s[lobe].push_back(s[lobe].value);
      result.dhr.p[lobe].push_back(p[lobe].value);
      result.dhr.error[lobe].push_back(std::max(s[lobe].error, p[lobe].error));
    }
  }
  return result;
}

Bhr bhr(const Engine& engine, const Band& band, const Variant& variant) {
  std::vector<Panel> open = first_panels(band.parameters);
  Bhr result{0, 0, 0};
  const double tolerance = engine.working() == Precision::float64 ? bhr_tolerance : 1e-5;
  for (int round = 0; !open.empty(); ++round) {
    integrate_panels(engine, band, variant, open);
    double total = result.s + result.p;
    for (const Panel& panel : open) total += panel.s + panel.p;
    std::vector<Panel> next;
    for (const Panel& panel : open) {
      if (panel.error <= tolerance * total || round + 1 == bhr_rounds) {
        result.s += panel.s;
        result.p += panel.p;
        result.error += panel.error;
        continue;
      }
      const double middle = 0.5 * (panel.begin + panel.end);
      next.push_back({panel.segment_begin, panel.segment_end, panel.begin, middle});
      next.push_back({panel.segment_begin, panel.segment_end, middle, panel.end});
    }
    open = std::move(next);
  }
  if (result.s + result.p > 0) result.error /= result.s + result.p;
  return result;
}

Bhr reference_bhr(const Band& band, const Variant& variant) {
  const auto total = [](const reference::LobeReflectance& r) { return r.total(); };
  const auto b = reference::Model(band.parameters, variant).bhr();
  return {total(b.s).value, total(b.p).value, std::max(total(b.s).error, total(b.p).error)};
}

}  // namespace brdftab

// MERL binary files hold isotropic RGB over half-way and difference angles, which readers look up by cell.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

#include "host/base/error.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/merl/merl_file.hpp"
#include "host/formats/merl/merl_measurement.hpp"
#include "host/formats/registry.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

constexpr double invalid = -1;
// Nearer to the horizon than 1e-4 degrees a node is on it but for rounding.
constexpr double least_cosine = 1.7453e-6;

// Cell 0 has its value at its centre, for readers that look cells up, or at its lower corner, for libbsdf,
// which interpolates.
enum class Registration { center, node };

double theta_h(int cell, Registration registration) {
  const double i = registration == Registration::center ? cell + 0.5 : cell;
  return i * i / MerlFile::cells_h;
}

// Gives the vectors to the light and to the viewer from the half-way vector, at azimuth 0, and the difference
// vector in the frame about it: x' lies in its plane, away from the normal's side, and y' is y.
std::pair<SurfaceVector, SurfaceVector> vectors(const SurfaceVector& h, const SurfaceVector& d) {
  const SurfaceVector across{d.x * h.z, d.y, -d.x * h.x};
  return {h * d.z + across, h * d.z + across * -1};
}

struct MerlValues {
  MerlFile file;
  std::size_t below_zero = 0;  // colours outside sRGB, written as 0
};

MerlValues merl_values(const ExportModel& source, Registration registration) {
  const bool center = registration == Registration::center;
  // phi_d covers half a turn. By the mirror plane its first and its last are light and viewer exchanged.
  const int phis = center ? MerlFile::cells_phi : MerlFile::cells_phi + 1;
  const double offset = center ? 0.5 : 0;
  Directions directions;
  std::vector<std::size_t> row;  // of each half turn among the valid ones
  constexpr std::size_t none = static_cast<std::size_t>(-1);
  std::vector<SurfaceVector> differences;
  for (int d = 0; d < MerlFile::cells_d; ++d)
    for (int phi = 0; phi < phis; ++phi)
      differences.push_back(SurfaceVector::from_degrees(d + offset, phi + offset));
  for (int h = 0; h < MerlFile::cells_h; ++h) {
    const SurfaceVector half = SurfaceVector::from_degrees(theta_h(h, registration), 0);
    for (const SurfaceVector& difference : differences) {
      const auto [light, viewer] = vectors(half, difference);
      const bool valid = std::min(light.z, viewer.z) > least_cosine;
      row.push_back(valid ? directions.size() : none);
      if (valid) add(directions, light, viewer);
    }
  }
  const auto rgb = source.rgb(source.evaluate(directions));
  MerlValues result;
  for (int c = 0; c < 3; ++c) {
    const auto& f = rgb[static_cast<std::size_t>(c)];
    auto half_turn = row.begin();
    for (int h = 0; h < MerlFile::cells_h; ++h)
      for (int d = 0; d < MerlFile::cells_d; ++d, half_turn += phis)
        for (int phi = 0; phi < MerlFile::cells_phi; ++phi) {
          const std::size_t here = half_turn[phi], exchanged = half_turn[phis - 1 - phi];
          double& value = result.file.values[MerlFile::index(c, h, d, phi)];
          value = invalid;
          if (here == none) continue;
          // Readers take phi_d and phi_d + 180 for the same, so a cell holds the mean of both directions of
          // light.
          const double mean = 0.5 * (f[here] + f[exchanged]);
          result.below_zero += mean < 0;
          value = std::max(mean, 0.) / MerlFile::scale(c);
        }
  }
  return result;
}

class MerlReader : public ExportReader {
 public:
  MerlReader(MerlFile file, Registration registration)
      : file_(std::move(file)), registration_(registration) {}

  ExportChannels channels() const override { return ExportChannels::rgb; }
  std::string interpolation() const override {
    return registration_ == Registration::center ? "cells, as the reference reader"
                                                 : "linear interpolation, as libbsdf";
  }

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override {
    std::vector<std::vector<double>> f(3, std::vector<double>(directions.size()));
    for (std::size_t k = 0; k < directions.size(); ++k) {
      HalfDifference at = half_difference(to_light(directions, k), to_viewer(directions, k));
      if (at.phi_d < 0) at.phi_d += 180;
      for (int c = 0; c < 3; ++c)
        f[static_cast<std::size_t>(c)][k] =
            MerlFile::scale(c) * (registration_ == Registration::center ? cell(c, at) : between_nodes(c, at));
    }
    return f;
  }

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    MerlFile right = merl_values(source, registration_).file;
    for (int c = 0; c < 3; ++c)
      for (int h = 0; h < MerlFile::cells_h; ++h)
        for (int d = 0; d < MerlFile::cells_d; ++d)
          for (int phi = 0; phi < MerlFile::cells_phi; ++phi) {
            const std::size_t at = MerlFile::index(c, h, d, phi);
            // Readers take what is below 0, a direction below the horizon, for 0.
            const auto f = [&](const MerlFile& file) {
              return MerlFile::scale(c) * std::max(file.values[at], 0.);
            };
            errors.compare(f(file_), f(right), [&] {
              return fmt::format("{} in the cell {}, {}, {} of theta_h, theta_d, phi_d", "RGB"[c], h, d, phi);
            });
          }
    return std::make_unique<MerlReader>(std::move(right), registration_);
  }

 private:
  double value(int channel, int h, int d, int phi) const {
    return std::max(
        0., file_.values[MerlFile::index(channel, std::min(h, MerlFile::cells_h - 1),
                                         std::min(d, MerlFile::cells_d - 1), phi % MerlFile::cells_phi)]);
  }
  // The value that MERL's reference reader takes.
  double cell(int channel, const HalfDifference& at) const {
    return value(channel, static_cast<int>(std::sqrt(at.theta_h * MerlFile::cells_h)),
                 static_cast<int>(at.theta_d), std::min(static_cast<int>(at.phi_d), MerlFile::cells_phi - 1));
  }
  // The value that libbsdf interpolates.
  double between_nodes(int channel, const HalfDifference& at) const {
    const int h =
        std::min(static_cast<int>(std::sqrt(at.theta_h * MerlFile::cells_h)), MerlFile::cells_h - 1);
    const int d = std::min(static_cast<int>(at.theta_d), MerlFile::cells_d - 1);
    const int phi = static_cast<int>(at.phi_d);
    const double low = theta_h(h, Registration::node), high = theta_h(h + 1, Registration::node);
    const std::array share{(at.theta_h - low) / (high - low), at.theta_d - d, at.phi_d - phi};
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const int a = corner & 1, b = corner >> 1 & 1, c = corner >> 2;
      sum += (a ? share[0] : 1 - share[0]) * (b ? share[1] : 1 - share[1]) * (c ? share[2] : 1 - share[2]) *
             value(channel, h + a, d + b, phi + c);
    }
    return sum;
  }

  MerlFile file_;
  Registration registration_;
};

class MerlFormat : public ExportFormat {
 public:
  MerlFormat()
      : ExportFormat(
            {.name = "merl",
             .consumer = "BRDF Explorer, pbrt-v2, ALTA, dj_brdf, libbsdf and most readers of MERL's data",
             .extensions = {".binary"},
             .suffix = ".binary",
             .holds_non_reciprocal = false,
             .measurement = MeasurementReader{.extensions = {".binary"}, .read = read_merl_measurement}}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "merl_registration",
             .help =
                 "center (default): values at the centres of cells, for readers that look cells up; node: "
                 "at i^2/90, j and k degrees, for libbsdf, which interpolates",
             .value = &registration_,
             .words = {"center", "node"},
             .is_for_reading = true}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    const auto [merl, below_zero] = merl_values(source, registration());
    write_whole(file, merl.bytes());
    if (below_zero == 0) return {};
    return {fmt::format("{} values of {} lie outside the colours of linear sRGB, below 0: written as 0",
                        below_zero, merl.values.size())};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    constexpr std::array<std::int32_t, 3> dimensions{MerlFile::cells_h, MerlFile::cells_d,
                                                     MerlFile::cells_phi};
    return beginning.size() > sizeof(dimensions) &&
           std::memcmp(beginning.data(), dimensions.data(), sizeof(dimensions)) == 0;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    std::ifstream in = open_file(file);
    return std::make_unique<MerlReader>(MerlFile::read(in, file.string()), registration());
  }

 private:
  Registration registration() const {
    return registration_ == "node" ? Registration::node : Registration::center;
  }

  std::string registration_ = "center";
};

}  // namespace

std::unique_ptr<Format> make_merl_format() { return std::make_unique<MerlFormat>(); }

}  // namespace brdftab

// Eradiate's MQDiffuseBSDF loads netCDF with one band of isotropic f over two cosines and the difference of
// azimuths.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/formats/export/export_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/hdf5/hdf5_file.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_attributes.hpp"

namespace brdftab {
namespace {

constexpr std::array<const char*, 3> dimensions{"cos_theta_o", "phi_d", "cos_theta_i"};
constexpr std::string_view hdf5_signature = "\x89HDF";

constexpr std::string_view directions_text =
    "Unit vectors to the light (i) and to the viewer (o), both away from the surface; phi_d is the "
    "difference of their azimuths: the mirror direction is cos_theta_o = cos_theta_i, phi_d = pi, and "
    "retro-reflection is phi_d = 0.";
constexpr std::string_view grazing_text =
    "The model ends before 90 degrees; nodes at a cosine of 0 hold f at half the cosine of the next node.";

// The place of a polar angle increases with it, as the nodes of an axis have to.
double place(double theta) { return 1 - std::cos(theta / degrees_per_radian); }

// Gives the polar angles of an axis of places. The node of a cosine of 0 stands at half the cosine of the
// next one.
std::vector<double> polar_angles(const std::vector<double>& places) {
  std::vector<double> theta;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const double cosine = 1 - places[k];
    theta.push_back(degrees(std::acos(cosine > 0 || k == 0 ? cosine : (1 - places[k - 1]) / 2)));
  }
  return theta;
}

class EradiateReader : public ExportReader {
 public:
  EradiateReader(GridSamples samples, std::string material_text, std::vector<double> wavelengths_nm)
      : samples_(std::move(samples)),
        material_text_(std::move(material_text)),
        wavelengths_nm_(std::move(wavelengths_nm)) {}

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override {
    Directions places = directions;
    for (double& theta : places.theta_i) theta = place(theta);
    for (double& theta : places.theta_s) theta = place(theta);
    return samples_.evaluate(places);
  }
  std::vector<double> wavelengths_nm() const override { return wavelengths_nm_; }
  std::string material_text() const override { return material_text_; }
  std::string interpolation() const override {
    return "linear interpolation in both cosines and in the azimuth";
  }
  AngleRange theta_i_range() const override { return range(AxisKind::theta_i); }
  AngleRange theta_s_range() const override { return range(AxisKind::theta_s); }
  AngleRange phi_range() const override { return samples_.phi_range(); }

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    check_channels(1, source.bands());
    const auto theta_i = polar_angles(samples_.axis(AxisKind::theta_i)),
               theta_s = polar_angles(samples_.axis(AxisKind::theta_s));
    Directions nodes;
    for (const double i : theta_i)
      for (const double s : theta_s)
        for (const double phi : samples_.axis(AxisKind::phi_s)) nodes.add(i, s, phi);
    auto f = source.evaluate(nodes);
    for (std::size_t k = 0; k < nodes.size(); ++k)
      errors.compare(samples_.values().front()[k], f.front()[k], [&] {
        return fmt::format("{} at {}", channel_name(channels(), source, 0), angles_text(nodes, k));
      });
    return std::make_unique<EradiateReader>(samples_.with_values(std::move(f)), material_text_,
                                            wavelengths_nm_);
  }

 private:
  AngleRange range(AxisKind kind) const {
    const auto [first, last] = samples_.range(kind);
    return {degrees(std::acos(1 - first)), degrees(std::acos(1 - last))};
  }

  GridSamples samples_;  // over 1 - cos theta in place of polar angles
  std::string material_text_;
  std::vector<double> wavelengths_nm_;
};

class EradiateFormat : public ExportFormat {
 public:
  EradiateFormat()
      : ExportFormat({.name = "eradiate",
                      .consumer = "Eradiate (MQDiffuseBSDF)",
                      .extensions = {},
                      .suffix = "_eradiate.nc",
                      .holds_bands = false}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "eradiate_cosines",
             .help = "Nodes in each cosine, from 0 to 1; default 91",
             .value = &cosines_,
             .range = {{3, 1001}}},
            {.name = "eradiate_azimuths",
             .help = "Nodes in the azimuth, from 0 to before 360 degrees; default 180",
             .value = &azimuths_,
             .range = {{4, 3600}}}};
  }

  std::vector<std::string> write(const std::filesystem::path& path,
                                 const ExportModel& source) const override {
    const Hdf5Silence silence;
    std::vector<double> cosines, theta, phi_d;
    for (int k = 0; k < cosines_; ++k) cosines.push_back(static_cast<double>(k) / (cosines_ - 1));
    for (const double cosine : cosines)
      theta.push_back(degrees(std::acos(cosine > 0 ? cosine : cosines[1] / 2)));
    for (int k = 0; k < azimuths_; ++k) phi_d.push_back(2 * std::numbers::pi * k / azimuths_);
    // f is even in the azimuth: the second half turn repeats the first.
    Directions directions;
    for (const double theta_s : theta)
      for (int k = 0; k <= azimuths_ / 2; ++k)
        for (const double theta_i : theta) directions.add(theta_i, theta_s, 360. * k / azimuths_ - 180);
    const std::vector<double> half = source.evaluate(directions).front();
    std::vector<float> samples;
    for (std::size_t o = 0; o < cosines.size(); ++o)
      for (int k = 0; k < azimuths_; ++k) {
        const auto row = o * static_cast<std::size_t>(azimuths_ / 2 + 1) +
                         static_cast<std::size_t>(std::min(k, azimuths_ - k));
        for (std::size_t i = 0; i < cosines.size(); ++i)
          samples.push_back(static_cast<float>(half[row * cosines.size() + i]));
      }
    Hdf5File file(path, H5F_LIBVER_V18);
    file.write_attributes(attributes(source));
    file.create_scale(dimensions[0], cosines, "1", "cosine of the polar angle of the viewer", "");
    file.create_scale(dimensions[1], phi_d, "rad", "difference of the azimuths of light and viewer", "");
    file.create_scale(dimensions[2], cosines, "1", "cosine of the polar angle of the light", "");
    {
      const Hdf5Handle brdf = file.create_variable(
          "brdf", {dimensions.begin(), dimensions.end()}, H5T_IEEE_F32LE, "sr-1",
          "bidirectional reflectance distribution function, unpolarised light", hdf5_dataset_properties());
      hdf5_check(H5Dwrite(brdf, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, samples.data()),
                 path.string());
    }
    file.close();
    return {};
  }

  bool recognises(const std::filesystem::path& path, std::string_view beginning) const override {
    if (!beginning.starts_with(hdf5_signature)) return false;
    const Hdf5Silence silence;
    const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    if (file < 0) return false;
    const Hdf5Handle closing(file, path.string());
    return H5Lexists(file, dimensions[0], H5P_DEFAULT) > 0;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& path) const override {
    const Hdf5Silence silence;
    const Hdf5Handle file(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), path.string() + ": is damaged");
    const auto dataset = [&](const std::string& name) {
      return Hdf5Handle(H5Dopen2(file, name.c_str(), H5P_DEFAULT),
                        fmt::format("{}: {}", path.string(), name));
    };
    const auto values = [&](const std::string& name) {
      const Hdf5Handle opened = dataset(name), space(H5Dget_space(opened), name);
      std::vector<double> result(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
      hdf5_check(H5Dread(opened, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, result.data()),
                 fmt::format("{}: {} is damaged", path.string(), name));
      return result;
    };
    const std::vector<double> cosines_o = values(dimensions[0]), phi_d = values(dimensions[1]),
                              cosines_i = values(dimensions[2]), brdf = values("brdf");
    if (brdf.size() != cosines_o.size() * phi_d.size() * cosines_i.size())
      throw BadInput("{}: brdf has {} samples, and its axes {} x {} x {} nodes", path.string(), brdf.size(),
                     cosines_o.size(), phi_d.size(), cosines_i.size());
    const auto places = [](const std::vector<double>& cosines) {
      std::vector<double> result;
      for (auto cosine = cosines.rbegin(); cosine != cosines.rend(); ++cosine) result.push_back(1 - *cosine);
      return result;
    };
    std::vector<double> azimuths, samples;
    for (const double azimuth : phi_d) azimuths.push_back(degrees(azimuth) - 180);
    for (std::size_t i = cosines_i.size(); i-- > 0;)
      for (std::size_t o = cosines_o.size(); o-- > 0;)
        for (std::size_t k = 0; k < phi_d.size(); ++k)
          samples.push_back(brdf[(o * phi_d.size() + k) * cosines_i.size() + i]);
    std::vector<double> wavelengths;
    const std::string text =
        has_text_attribute(file, "material") ? read_text_attribute(file, "material") : "";
    if (H5Aexists(file, "wavelength_nm") > 0) {
      const Hdf5Handle attribute(H5Aopen(file, "wavelength_nm", H5P_DEFAULT), "wavelength_nm");
      hdf5_check(H5Aread(attribute, H5T_NATIVE_DOUBLE, &wavelengths.emplace_back()), "wavelength_nm");
    }
    return std::make_unique<EradiateReader>(
        GridSamples({places(cosines_i), {0}, places(cosines_o), std::move(azimuths)}, {std::move(samples)},
                    path.string()),
        text, wavelengths);
  }

 private:
  static std::vector<AttributeInfo> attributes(const ExportModel& source) {
    std::vector<AttributeInfo> list{{"Conventions", std::string("CF-1.10")},
                                    {"title", fmt::format("BRDF of {}", source.material().name())},
                                    {"source", std::string(program_version)},
                                    {"references", std::string(paper_reference)},
                                    {"history", source.history()},
                                    {"direction_convention", std::string(directions_text)},
                                    {"grazing_nodes", std::string(grazing_text)}};
    const auto wavelengths = source.wavelengths_nm();
    if (!wavelengths.empty()) list.push_back({"wavelength_nm", wavelengths.front()});
    for (auto& attribute : material_attributes(source.material())) list.push_back(std::move(attribute));
    return list;
  }

  int cosines_ = 91;
  int azimuths_ = 180;
};

}  // namespace

std::unique_ptr<Format> make_eradiate_format() { return std::make_unique<EradiateFormat>(); }

}  // namespace brdftab

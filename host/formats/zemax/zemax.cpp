// Zemax OpticStudio's tabular BSDF has scatter angles about the specular direction, and the reflectance at
// each incidence.
#include <algorithm>
#include <fstream>
#include <iterator>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/registry.hpp"
#include "host/formats/zemax/zemax_file.hpp"
#include "host/formats/zemax/zemax_measurement.hpp"
#include "host/model/surface_vector.hpp"

namespace brdftab {
namespace {

constexpr std::string_view title = "Zemax tabular BSDF";

// Radial angles, degrees, lie closer near the specular direction.
std::vector<double> default_radials() {
  std::vector<double> radials{0};
  const auto up_to = [&](double last, double steps_per_degree) {
    const double first = radials.back();
    for (int k = 1; k <= static_cast<int>((last - first) * steps_per_degree); ++k)
      radials.push_back(first + k / steps_per_degree);
  };
  up_to(1, 10);
  up_to(5, 2);
  up_to(20, 1);
  up_to(180, 0.5);
  return radials;
}

// The file's axes lie in GridSamples as theta_i, phi_i (sample rotation), theta_s (radial) and phi_s
// (azimuth).
class ZemaxReader : public ExportReader {
 public:
  ZemaxReader(ZemaxFile file, Description description, GridSamples samples)
      : file_(std::move(file)), description_(std::move(description)), samples_(std::move(samples)) {}

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override {
    Directions specular;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const auto [radial, azimuth] = specular_angles(directions.theta_i[k], to_viewer(directions, k));
      specular.add(directions.theta_i[k], radial, azimuth);
    }
    return samples_.evaluate(specular);
  }
  ExportChannels channels() const override {
    return file_.blocks.size() == 3 ? ExportChannels::xyz : ExportChannels::bands;
  }
  Illuminant illuminant() const override { return description_.illuminant; }
  std::vector<double> wavelengths_nm() const override { return description_.wavelengths_nm; }
  std::string material_text() const override { return description_.material_text; }
  std::string interpolation() const override {
    return "linear interpolation about the specular direction, as libbsdf";
  }
  AngleRange theta_i_range() const override { return samples_.range(AxisKind::theta_i); }
  bool covers(const Directions& directions, std::size_t k) const override {
    const auto [radial, azimuth] = specular_angles(directions.theta_i[k], to_viewer(directions, k));
    return radial >= file_.radial.front() && radial <= file_.radial.back();
  }

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    check_channels(file_.blocks.size(),
                   channels() == ExportChannels::bands ? source.bands() : file_.blocks.size());
    compare_reflectance(source, errors);
    const Directions nodes = samples_.directions();
    Directions above;
    std::vector<std::size_t> node_above;
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      const SurfaceVector viewer = about_specular(nodes.theta_i[k], nodes.theta_s[k], nodes.phi[k]);
      if (!is_above(viewer)) continue;
      above.add(nodes.theta_i[k], viewer.theta(), viewer.phi());
      node_above.push_back(k);
    }
    const auto f = in_channels(channels(), source, source.evaluate(above));
    std::vector<std::vector<double>> values(f.size(), std::vector<double>(nodes.size()));
    for (std::size_t c = 0; c < f.size(); ++c) {
      for (std::size_t k = 0; k < above.size(); ++k) values[c][node_above[k]] = f[c][k];
      for (std::size_t k = 0; k < nodes.size(); ++k)
        errors.compare(samples_.values()[c][k], values[c][k], [&] {
          return fmt::format("{} at AngleOfIncidence {:.6g}, ScatterAzimuth {:.6g}, ScatterRadial {:.6g}",
                             channel_name(channels(), source, c), nodes.theta_i[k], nodes.phi[k],
                             nodes.theta_s[k]);
        });
    }
    return std::make_unique<ZemaxReader>(file_, description_, samples_.with_values(std::move(values)));
  }

  static bool is_above(const SurfaceVector& viewer) { return viewer.theta() < largest_theta; }

 private:
  static constexpr double largest_theta = 89.9999;

  void compare_reflectance(const ExportModel& source, ValueErrors& errors) const {
    const auto reflectance = in_channels(channels(), source, source.dhr(file_.incidence));
    for (std::size_t c = 0; c < reflectance.size(); ++c)
      for (std::size_t i = 0; i < file_.incidence.size(); ++i)
        errors.compare(file_.blocks[c].tis.at(i), reflectance[c][i], [&] {
          return fmt::format("TIS of {} at AngleOfIncidence {:.6g}", channel_name(channels(), source, c),
                             file_.incidence[i]);
        });
  }

  ZemaxFile file_;
  Description description_;
  GridSamples samples_;
};

class ZemaxFormat : public ExportFormat {
 public:
  ZemaxFormat()
      : ExportFormat(
            {.name = "zemax",
             .consumer = "Zemax OpticStudio (tabular BSDF), and importers of its files; XYZ where "
                         "there are several bands",
             .extensions = {},
             .suffix = "_zemax.bsdf",
             .measurement = MeasurementReader{.extensions = {".bsdf"}, .read = read_zemax_measurement}}) {}

  std::vector<FormatOption> options() override {
    const auto angles = [](const char* name, std::string& text, std::string_view what) {
      return FormatOption{
          .name = name,
          .help =
              fmt::format("{}, degrees: start:stop:step, or angles separated by commas; default: {}", what,
                          text.empty() ? "0.1 apart up to 1, 0.5 up to 5, 1 up to 20, then 2" : text),
          .value = &text};
    };
    return {
        angles("zemax_incidence", incidence_, "AngleOfIncidence"),
        angles("zemax_azimuth", azimuth_,
               "ScatterAzimuth about the specular direction, from 0, toward the normal, to 180"),
        angles("zemax_radial", radial_, "ScatterRadial, from the specular direction, from 0 to at most 180")};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    ZemaxFile zemax = axes();
    fill(zemax, source);
    zemax.comments.emplace_back(title);
    for (auto& line :
         description_lines(source, zemax.blocks.size() == 3 ? ExportChannels::xyz : ExportChannels::bands))
      zemax.comments.push_back(std::move(line));
    write_whole(file, zemax.text());
    return notes_of(zemax);
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    if (beginning.starts_with(fmt::format("# {}", title))) return true;
    while (beginning.starts_with('#'))
      beginning.remove_prefix(std::min(beginning.find('\n'), beginning.size() - 1) + 1);
    return beginning.starts_with("Source") && beginning.find("SampleRotation") != beginning.npos;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& path) const override {
    std::ifstream in = open_file(path);
    ZemaxFile file = ZemaxFile::read(in, path.string());
    if (file.blocks.size() != 1 && file.blocks.size() != 3)
      throw BadInput("{}: has {} blocks of data; Monochrome has one, XYZ three", path.string(),
                     file.blocks.size());
    const std::vector<std::string_view> contents =
        file.blocks.size() == 1
            ? std::vector<std::string_view>{"Monochrome"}
            : std::vector<std::string_view>{"TristimulusX", "TristimulusY", "TristimulusZ"};
    for (std::size_t c = 0; c < contents.size(); ++c)
      if (file.blocks[c].content != contents[c])
        throw BadInput("{}: block {} is {}; must be {}", path.string(), c + 1, file.blocks[c].content,
                       contents[c]);
    if (file.rotation.size() != 1)
      throw BadInput("{}: has {} rotations of the sample; an isotropic one has one", path.string(),
                     file.rotation.size());
    Description description;
    for (const auto& line : file.comments) description.read(line);
    // The order [incidence][azimuth][radial] becomes [incidence][rotation][radial][azimuth].
    std::vector<std::vector<double>> values;
    const std::size_t azimuths = file.azimuth.size(), radials = file.radial.size();
    for (const ZemaxBlock& block : file.blocks) {
      auto& turned = values.emplace_back(block.values.size());
      for (std::size_t i = 0; i < file.incidence.size(); ++i)
        for (std::size_t a = 0; a < azimuths; ++a)
          for (std::size_t r = 0; r < radials; ++r)
            turned[(i * radials + r) * azimuths + a] = block.values[(i * azimuths + a) * radials + r];
    }
    GridSamples samples({file.incidence, file.rotation, file.radial, file.azimuth}, std::move(values),
                        path.string());
    return std::make_unique<ZemaxReader>(std::move(file), std::move(description), std::move(samples));
  }

 private:
  ZemaxFile axes() const {
    ZemaxFile file;
    file.symmetry = "PlaneSymmetrical";
    file.rotation = {0};
    file.incidence = nodes("zemax_incidence", incidence_, AxisKind::theta_i);
    file.azimuth = nodes("zemax_azimuth", azimuth_, AxisKind::phi_s);
    file.radial = radial_.empty() ? default_radials() : nodes("zemax_radial", radial_, AxisKind::phi_s);
    if (file.azimuth.front() != 0 || file.azimuth.back() != 180)
      throw BadInput(GivenValue{"zemax_azimuth", excerpt(azimuth_)},
                     "must begin with 0 and end with 180, the plane of symmetry");
    if (file.radial.front() != 0 || file.radial.back() > 180)
      throw BadInput(GivenValue{"zemax_radial", excerpt(radial_)},
                     "must begin with 0 and end at 180 at most");
    return file;
  }

  static std::vector<double> nodes(const char* option, const std::string& text, AxisKind kind) {
    try {
      const Axis axis = Axis::parse(kind, text);
      return {axis.nodes().begin(), axis.nodes().end()};
    } catch (const BadInput& error) {
      throw BadInput(GivenValue{option, excerpt(text)}, "{}", error.what());
    }
  }

  // Directions below the horizon hold 0.
  static void fill(ZemaxFile& file, const ExportModel& source) {
    Directions directions;
    std::vector<bool> is_above;
    for (const double theta_i : file.incidence)
      for (const double psi : file.azimuth)
        for (const double r : file.radial) {
          const SurfaceVector viewer = about_specular(theta_i, r, psi);
          is_above.push_back(ZemaxReader::is_above(viewer));
          if (is_above.back()) directions.add(theta_i, viewer.theta(), viewer.phi());
        }
    auto f = source.evaluate(directions);
    auto reflectance = source.dhr(file.incidence);
    if (source.bands() > 1) {
      f = source.xyz(f);
      reflectance = source.xyz(reflectance);
    }
    for (std::size_t c = 0; c < f.size(); ++c) {
      ZemaxBlock& block = file.blocks.emplace_back();
      block.content = f.size() == 1 ? "Monochrome" : fmt::format("Tristimulus{}", "XYZ"[c]);
      block.tis = reflectance[c];
      auto value = f[c].begin();
      for (const bool above : is_above) block.values.push_back(above ? *value++ : 0);
    }
  }

  static std::vector<std::string> notes_of(const ZemaxFile& file) {
    std::size_t values = 0, above_one = 0;
    double largest = 0;
    for (const ZemaxBlock& block : file.blocks)
      for (const double tis : block.tis) {
        ++values;
        above_one += tis > 1;
        largest = std::max(largest, tis);
      }
    if (above_one == 0) return {};
    return {fmt::format("TIS, the model's DHR, is above 1 at {} of {} incidences, {:.3g} at most", above_one,
                        values, largest)};
  }

  std::string incidence_ = "0:85:2.5";
  std::string azimuth_ = "0:180:5";
  std::string radial_;
};

}  // namespace

std::unique_ptr<Format> make_zemax_format() { return std::make_unique<ZemaxFormat>(); }

}  // namespace brdftab

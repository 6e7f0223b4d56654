// The adaptive tables of the RGL material database, for the `measured` materials of Mitsuba 3 and pbrt-v4.
#include <algorithm>

#include "host/base/angle.hpp"
#include "host/base/error.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/registry.hpp"
#include "host/formats/rgl/rgl_design.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

// Consumers count a table's values in 32 bits, and hold it several times over.
constexpr std::size_t most_bytes = 4'000'000'000;

class RglReader : public ExportReader {
 public:
  RglReader(RglContent content, Description description)
      : content_(std::move(content)), description_(std::move(description)), vndf_(content_.vndf_warp()) {}

  std::vector<std::vector<double>> evaluate(const Directions& directions) const override {
    const SquareTable ndf = content_.ndf_table(), sigma = content_.sigma_table(),
                      spectra = content_.spectra_table();
    std::vector<std::vector<double>> f(content_.channels, std::vector<double>(directions.size()));
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const SurfaceVector i = to_viewer(directions, k), o = to_light(directions, k);
      const SquarePoint half = RglPlace::of((i + o).normalized(), i.phi());
      const AxisPlace theta_i(content_.theta_i, radians(i.theta()));
      const SquarePoint s = vndf_.invert(theta_i, half).point;
      const double scale = ndf.at(0, half) / (4 * sigma.at(0, {RglPlace::of_theta(i.theta()), 0.5}) * o.z);
      const auto slice = [&](std::size_t node, std::size_t channel) {
        return node * content_.channels + channel;
      };
      for (std::size_t c = 0; c < f.size(); ++c)
        f[c][k] = scale *
                  theta_i.mix(spectra.at(slice(theta_i.lower, c), s), spectra.at(slice(theta_i.upper, c), s));
    }
    return f;
  }

  ExportChannels channels() const override {
    return content_.wavelengths_nm.empty() ? ExportChannels::rgb : ExportChannels::bands;
  }
  Illuminant illuminant() const override { return description_.illuminant; }
  std::vector<double> wavelengths_nm() const override { return description_.wavelengths_nm; }
  std::string material_text() const override { return description_.material_text; }
  std::string interpolation() const override {
    return "interpolation linear in theta_i and wavelength, bilinear over half vectors warped by the density "
           "in the file";
  }
  // The file's theta_i is the viewer's.
  AngleRange theta_s_range() const override {
    return {content_.theta_i.front() / radians_per_degree, content_.theta_i.back() / radians_per_degree};
  }

  std::unique_ptr<ExportReader> rebuilt(const ExportModel& source, ValueErrors& errors) const override {
    RglDesign right = resampled_rgl(source, content_);
    const std::size_t n = content_.samples, square = n * n;
    const auto place = [&](std::size_t i, std::size_t k) {
      return fmt::format("theta_i = {:.6g} degrees, node {}, {}", content_.theta_i[i] / radians_per_degree,
                         k / n, k % n);
    };
    for (std::size_t i = 0; i < content_.theta_i.size(); ++i)
      for (std::size_t k = 0; k < square; ++k) {
        const std::size_t at = i * square + k;
        errors.compare(content_.luminance[at], right.content.luminance[at],
                       [&] { return fmt::format("luminance at {}", place(i, k)); });
        // A value is compared as f where f has a part in it.
        const double scale = right.scale[at] > 0 ? right.scale[at] : 1;
        for (std::size_t c = 0; c < content_.channels; ++c) {
          const std::size_t value = (i * content_.channels + c) * square + k;
          errors.compare(content_.spectra[value] / scale, right.content.spectra[value] / scale, [&] {
            return fmt::format("f in {} at {}", channel_name(channels(), source, c), place(i, k));
          });
        }
      }
    return std::make_unique<RglReader>(std::move(right.content), description_);
  }

 private:
  RglContent content_;
  Description description_;
  AdaptiveWarp vndf_;
};

class RglFormat : public ExportFormat {
 public:
  RglFormat()
      : ExportFormat({.name = "rgl",
                      .consumer = "Mitsuba 3 (measured), pbrt-v4 (measured), powitacq",
                      .extensions = {},
                      .suffix = "_rgl.bsdf"}) {}

  std::vector<FormatOption> options() override {
    constexpr FormatOption::Range nodes{2, 4096};
    return {{.name = "rgl_channels",
             .help = "rgb: linear sRGB, for Mitsuba's rgb variants (default); spectral: the bands, for its "
                     "spectral variants and pbrt-v4",
             .value = &channels_,
             .words = {"rgb", "spectral"}},
            {.name = "rgl_theta_i",
             .help = "Nodes of theta_i, the viewer's; default 90",
             .value = &resolution_.theta_i,
             .range = nodes},
            {.name = "rgl_samples",
             .help = "Nodes of f along each side of the warped square; default 96",
             .value = &resolution_.samples,
             .range = nodes},
            {.name = "rgl_warp_theta",
             .help = "Nodes of the warp's density along theta; default 256",
             .value = &resolution_.warp_theta,
             .range = nodes},
            {.name = "rgl_warp_phi",
             .help = "Nodes of the warp's density along phi, an odd number; default 129",
             .value = &resolution_.warp_phi,
             .range = nodes}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    if (resolution_.warp_phi % 2 == 0)
      throw BadInput(GivenValue{"rgl_warp_phi", fmt::format("{}", resolution_.warp_phi)},
                     "must be odd, so that a row lies in the plane of incidence");
    const bool rgb = channels_ == "rgb";
    const std::size_t channels = rgb ? 3 : source.bands();
    const std::size_t bytes = 4 * resolution_.theta_i *
                              ((channels + 1) * resolution_.samples * resolution_.samples +
                               resolution_.warp_theta * resolution_.warp_phi);
    if (bytes > most_bytes)
      throw BadInput(
          "`rgl_theta_i`, `rgl_samples`, `rgl_warp_theta` and `rgl_warp_phi`: the file would have {:.3g} GB; "
          "at most 4",
          static_cast<double>(bytes) / 1e9);
    const RglDesign design = design_rgl(source, resolution_, rgb ? RglChannels::rgb : RglChannels::spectral);
    TensorFields fields = design.content.fields();
    fields["description"] = Tensor::of_text(fmt::format("{}, {}", source.material().name(), program_version));
    std::string text;
    for (const auto& line : description_lines(source, rgb ? ExportChannels::rgb : ExportChannels::bands))
      text += line + '\n';
    fields["comments"] = Tensor::of_text(text);
    write_tensor_file(file, fields);
    std::vector<std::string> notes;
    if (design.negative_colours > 0)
      notes.push_back(fmt::format("{} of {} samples of colours outside sRGB are below 0, and written as 0",
                                  design.negative_colours, design.content.spectra.size()));
    return notes;
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with(tensor_file_magic);
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    const TensorFields fields = read_tensor_file(file);
    Description description;
    if (const auto comments = fields.find("comments"); comments != fields.end()) {
      const std::string text(comments->second.bytes.begin(), comments->second.bytes.end());
      for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        description.read(std::string_view(text).substr(begin, end - begin));
        begin = end + 1;
      }
    }
    return std::make_unique<RglReader>(RglContent::from_fields(file, fields), std::move(description));
  }

 private:
  RglResolution resolution_;
  std::string channels_ = "rgb";
};

}  // namespace

std::unique_ptr<Format> make_rgl_format() { return std::make_unique<RglFormat>(); }

}  // namespace brdftab

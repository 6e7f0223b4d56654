#include "host/formats/exr/exr_writer.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfMultiPartOutputFile.h>
#include <OpenEXR/ImfOutputPart.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfTileDescriptionAttribute.h>
#include <OpenEXR/ImfTiledOutputPart.h>

#include <set>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/parallel.hpp"
#include "host/base/scratch_file.hpp"
#include "host/formats/exr/exr_stream.hpp"
#include "host/table/table_attributes.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

// OpenEXR counts pixels in int.
constexpr std::size_t most_pixels = 1 << 30;

std::string comma_separated(std::span<const double> values) {
  std::string text;
  for (const double value : values) text += fmt::format("{}{}", text.empty() ? "" : ",", shortest(value));
  return text;
}

// OpenEXR's threads work for all files of the process. Where nobody has started any, they are started for the
// first file that is compressed, and stay.
int threads_of_process() {
  if (Imf::globalThreadCount() == 0) Imf::setGlobalThreadCount(static_cast<int>(hardware_threads()));
  return Imf::globalThreadCount();
}

std::string prefixed(std::string_view name) { return std::string(exr_prefix) + std::string(name); }

void insert(Imf::Header& header, const std::string& name, const AttributeValue& value) {
  if (const auto* text = std::get_if<std::string>(&value))
    header.insert(name, Imf::StringAttribute(*text));
  else if (const auto* number = std::get_if<double>(&value))
    header.insert(name, Imf::DoubleAttribute(*number));
  else
    header.insert(name, Imf::StringAttribute(comma_separated(std::get<std::vector<double>>(value))));
}

// This folder vanishes unless it is given its name.
class ScratchFolder {
 public:
  explicit ScratchFolder(fs::path path) : path_(std::move(path)) { fs::create_directory(path_); }
  ~ScratchFolder() {
    std::error_code error;
    fs::remove_all(path_, error);
  }
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

class ExrWriter : public TableWriter {
 public:
  ExrWriter(const fs::path& path, const TableContent& content, const ExrOptions& options)
      : path_(path),
        content_(content),
        options_(options),
        grid_(content.grid),
        slices_(grid_.theta_i.size() * grid_.phi_i.size()),
        channels_(channels()),
        scratch_(path, scratch_bytes()) {}

  void write(std::size_t polarization, std::size_t band, const Slab& slab,
             std::span<const std::byte> samples) override {
    const std::size_t slice = slab.theta_i.begin * grid_.phi_i.size() + slab.phi_i.begin;
    const std::size_t row = slice * grid_.theta_s.size() + slab.theta_s.begin;
    const std::size_t channel = band * content_.polarizations.size() + polarization;
    scratch_.write((channel * grid_.directions() + row * grid_.phi_s.size()) * sizeof(float), samples);
  }

  void finish(const TableFindings& findings) override {
    samples_.resize(channels_.size() * slice_nodes());
    try {
      if (options_.layout == ExrLayout::parts)
        write_parts(findings);
      else if (options_.layout == ExrLayout::tiles)
        write_tiles(findings);
      else
        write_files(findings);
    } catch (const Iex::BaseExc& error) {
      throw FileError("{}", error.what());
    }
  }

 private:
  // Channels go by band, then by polarisation.
  std::vector<std::string> channels() const {
    std::vector<std::string> names;
    for (const Band& band : content_.material.bands())
      for (const Polarization polarization : content_.polarizations)
        names.push_back(exr_channel(polarization, band.wavelength_nm));
    if (std::set(names.begin(), names.end()).size() < names.size())
      throw BadInput(
          "{}: OpenEXR's spectral channels tell wavelengths apart by 1e-6 nm; two bands are nearer",
          content_.material.name());
    return names;
  }

  std::size_t scratch_bytes() const {
    require_representable();
    return channels_.size() * grid_.directions() * sizeof(float);
  }

  void require_representable() const {
    if (content_.precision != Precision::float32)
      throw BadInput("OpenEXR holds float32 only: `precision` float64 needs HDF5");
    if (options_.layout == ExrLayout::parts && slices_ > most_exr_parts)
      throw BadInput(
          "{} slices (theta_i x phi_i) are too many for parts of one OpenEXR file: at most {}, as viewers "
          "load all of them; `exr_layout` tiles makes one tiled image, `exr_layout` files a file for each "
          "slice; HDF5 has no such limit",
          slices_, most_exr_parts);
    const std::size_t across = options_.layout == ExrLayout::tiles ? grid_.phi_i.size() : 1;
    const std::size_t down = options_.layout == ExrLayout::tiles ? grid_.theta_i.size() : 1;
    const std::size_t width = grid_.phi_s.size() * across;
    const std::size_t height = grid_.theta_s.size() * down;
    const std::size_t slice_bytes =
        grid_.phi_s.size() * grid_.theta_s.size() * channels_.size() * sizeof(float);
    if (width > most_pixels || height > most_pixels || slice_bytes > most_pixels)
      throw BadInput(
          "an image of {} x {} pixels with {} channels is beyond what OpenEXR holds; HDF5 has no such limit",
          width, height, channels_.size());
  }

  Imf::Header header(std::size_t width, std::size_t height) const {
    Imf::Header result(static_cast<int>(width), static_cast<int>(height));
    result.compression() =
        options_.compression == ExrCompression::zip ? Imf::ZIP_COMPRESSION : Imf::NO_COMPRESSION;
    for (const auto& channel : channels_) result.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    const auto text = [&](std::string_view name, std::string_view value) {
      result.insert(prefixed(name), Imf::StringAttribute(std::string(value)));
    };
    text("units", "sr-1");
    text("angle_units", "degree");
    text("x", "phi_s");
    text("y", "theta_s");
    text("theta_s", comma_separated(grid_.theta_s.nodes()));
    text("phi_s", comma_separated(grid_.phi_s.nodes()));
    if (content_.material.has_wavelengths()) {
      result.insert("spectralLayoutVersion", Imf::StringAttribute("1.0"));
      std::vector<double> wavelengths;
      for (const Band& band : content_.material.bands()) wavelengths.push_back(*band.wavelength_nm);
      text("wavelength", comma_separated(wavelengths));
      text("spectral_quantity", "channels T hold f in 1/sr, not a reflectance");
    }
    return result;
  }

  void describe_slice(Imf::Header& header, std::size_t slice) const {
    const std::size_t i = slice / grid_.phi_i.size();
    const std::size_t p = slice % grid_.phi_i.size();
    header.setName(exr_slice_name(grid_.theta_i, i, grid_.phi_i, p));
    header.insert(std::string(exr_slice_theta_i), Imf::DoubleAttribute(grid_.theta_i[i]));
    header.insert(std::string(exr_slice_phi_i), Imf::DoubleAttribute(grid_.phi_i[p]));
  }

  void describe_table(Imf::Header& header, const TableFindings& findings) const {
    insert(header, prefixed("layout"),
           std::string(exr_layout_names[static_cast<std::size_t>(options_.layout)]));
    insert(header, prefixed("theta_i"), comma_separated(grid_.theta_i.nodes()));
    insert(header, prefixed("phi_i"), comma_separated(grid_.phi_i.nodes()));
    // The conventions of CF are for netCDF only.
    for (const auto& attribute : content_attributes(content_))
      if (attribute.name != "Conventions") insert(header, prefixed(attribute.name), attribute.value);
    for (const auto& integral : integral_variables(findings.integrals))
      insert(header, prefixed(integral.name), comma_separated(integral.values));
    for (const auto& attribute : findings_attributes(findings))
      insert(header, prefixed(attribute.name), attribute.value);
  }

  // What is not compressed is written fastest by one thread.
  int threads() const { return options_.compression == ExrCompression::zip ? threads_of_process() : 0; }

  std::size_t slice_nodes() const { return grid_.theta_s.size() * grid_.phi_s.size(); }

  // Reads a slice, and gives its samples as the image whose pixel (0, 0) is its first node.
  Imf::FrameBuffer frame(std::size_t slice, bool tile) {
    const std::size_t row = grid_.phi_s.size() * sizeof(float);
    Imf::FrameBuffer buffer;
    for (std::size_t k = 0; k < channels_.size(); ++k) {
      const std::span<float> samples = std::span(samples_).subspan(k * slice_nodes(), slice_nodes());
      scratch_.read((k * grid_.directions() + slice * slice_nodes()) * sizeof(float),
                    std::as_writable_bytes(samples));
      buffer.insert(channels_[k], Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(samples.data()),
                                             sizeof(float), row, 1, 1, 0, tile, tile));
    }
    return buffer;
  }

  void write_scanlines(const fs::path& file, const std::vector<Imf::Header>& headers,
                       std::size_t first_slice) {
    ExrStream stream(file);
    {
      Imf::MultiPartOutputFile out(stream, headers.data(), static_cast<int>(headers.size()), false,
                                   threads());
      for (std::size_t k = 0; k < headers.size(); ++k) {
        content_.watch.stop_if_asked();
        Imf::OutputPart part(out, static_cast<int>(k));
        part.setFrameBuffer(frame(first_slice + k, false));
        part.writePixels(static_cast<int>(grid_.theta_s.size()));
      }
    }
    stream.close();
  }

  Imf::Header slice_header(std::size_t slice) const {
    Imf::Header result = header(grid_.phi_s.size(), grid_.theta_s.size());
    result.setType(Imf::SCANLINEIMAGE);
    describe_slice(result, slice);
    return result;
  }

  void write_parts(const TableFindings& findings) {
    std::vector<Imf::Header> headers;
    for (std::size_t slice = 0; slice < slices_; ++slice) headers.push_back(slice_header(slice));
    describe_table(headers.front(), findings);
    write_scanlines(path_, headers, 0);
  }

  void write_files(const TableFindings& findings) {
    const ScratchFolder folder(path_.string() + ".slices");
    for (std::size_t slice = 0; slice < slices_; ++slice) {
      Imf::Header one = slice_header(slice);
      describe_table(one, findings);
      write_scanlines(folder.path() / (one.name() + ".exr"), {one}, slice);
    }
    fs::remove(path_);
    fs::rename(folder.path(), path_);
  }

  void write_tiles(const TableFindings& findings) {
    Imf::Header whole =
        header(grid_.phi_s.size() * grid_.phi_i.size(), grid_.theta_s.size() * grid_.theta_i.size());
    whole.setTileDescription({static_cast<unsigned>(grid_.phi_s.size()),
                              static_cast<unsigned>(grid_.theta_s.size()), Imf::ONE_LEVEL});
    whole.setType(Imf::TILEDIMAGE);
    describe_table(whole, findings);
    ExrStream stream(path_);
    {
      Imf::MultiPartOutputFile out(stream, &whole, 1, false, threads());
      Imf::TiledOutputPart part(out, 0);
      for (std::size_t slice = 0; slice < slices_; ++slice) {
        content_.watch.stop_if_asked();
        part.setFrameBuffer(frame(slice, true));
        part.writeTile(static_cast<int>(slice % grid_.phi_i.size()),
                       static_cast<int>(slice / grid_.phi_i.size()));
      }
    }
    stream.close();
  }

  fs::path path_;
  TableContent content_;
  ExrOptions options_;
  const Grid& grid_;
  std::size_t slices_;
  std::vector<std::string> channels_;
  ScratchFile scratch_;
  std::vector<float> samples_;  // of a slice, [channel][theta_s][phi_s]
};

}  // namespace

std::unique_ptr<TableWriter> create_exr_writer(const fs::path& file, const TableContent& content,
                                               const ExrOptions& options) {
  return std::make_unique<ExrWriter>(file, content, options);
}

}  // namespace brdftab

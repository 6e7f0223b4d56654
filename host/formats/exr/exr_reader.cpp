#include "host/formats/exr/exr_reader.hpp"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputPart.h>
#include <OpenEXR/ImfMultiPartInputFile.h>
#include <OpenEXR/ImfPartType.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfTiledInputPart.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/formats/exr/exr_names.hpp"
#include "host/table/table_attributes.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {
namespace {

namespace fs = std::filesystem;

// Tables are read in small pieces, which one thread takes as fast.
constexpr int no_threads = 0;

std::vector<double> numbers(std::string_view text) {
  std::vector<double> values;
  while (!text.empty()) {
    const auto comma = text.find(',');
    values.push_back(parse_number(text.substr(0, comma)).value_or(NAN));
    text.remove_prefix(comma == text.npos ? text.size() : comma + 1);
  }
  return values;
}

std::optional<std::string> text_of(const Imf::Header& header, std::string_view name) {
  const auto* attribute =
      header.findTypedAttribute<Imf::StringAttribute>(std::string(exr_prefix) + std::string(name));
  return attribute ? std::optional(attribute->value()) : std::nullopt;
}

// Finds the node that a slice's angle names: attributes keep doubles whole, so that both are equal.
std::optional<std::size_t> index_of(const std::vector<double>& axis, const Imf::Header& header,
                                    std::string_view name) {
  const auto* angle = header.findTypedAttribute<Imf::DoubleAttribute>(std::string(name));
  if (!angle) return std::nullopt;
  const auto at = std::find(axis.begin(), axis.end(), angle->value());
  if (at == axis.end()) return std::nullopt;
  return static_cast<std::size_t>(at - axis.begin());
}

class ExrReader : public TableReader {
 public:
  explicit ExrReader(const fs::path& path) : path_(path) {
    guarded([&] {
      if (fs::is_directory(path))
        open_folder();
      else
        open(path);
      read_info();
      place_slices();
    });
  }

  const TableInfo& info() const override { return info_; }

  void read(Polarization polarization, std::size_t band, const Slab& box,
            std::span<double> samples) override {
    const std::string channel =
        exr_channel(polarization, wavelengths_.empty() ? std::nullopt : std::optional(wavelengths_.at(band)));
    guarded([&] {
      if (tiles_)
        read_tiles(channel, box, samples);
      else
        read_slices(channel, box, samples);
    });
  }

 private:
  struct Slice {
    std::size_t file = 0;
    int part = -1;
  };

  // OpenEXR's exceptions name the fault, not the table.
  template <class Work>
  void guarded(Work work) const {
    try {
      work();
    } catch (const Iex::BaseExc& error) {
      throw FileError("{}: is damaged or truncated: {}", path_.string(), error.what());
    }
  }

  void open(const fs::path& file) {
    auto input = std::make_unique<Imf::MultiPartInputFile>(file.c_str(), no_threads);
    for (int part = 0; part < input->parts(); ++part)
      if (!input->partComplete(part))
        throw FileError("{}: is truncated: part {} is not complete", file.string(), part);
    files_.push_back(std::move(input));
  }

  void open_folder() {
    std::vector<fs::path> names;
    for (const auto& entry : fs::directory_iterator(path_))
      if (entry.path().extension() == ".exr") names.push_back(entry.path());
    if (names.empty()) throw BadInput("{}: is a folder without OpenEXR files", path_.string());
    // Slices are placed by their attributes; the order only decides which file speaks for all.
    std::sort(names.begin(), names.end());
    for (const auto& name : names) open(name);
  }

  const Imf::Header& first() const { return files_.front()->header(0); }

  void add_axis(std::string_view name, std::string_view units, std::string_view long_name) {
    const auto text = text_of(first(), name);
    if (!text) return;
    const auto values = numbers(*text);
    info_.variables.push_back({.name = std::string(name),
                               .type = "float64",
                               .shape = {values.size()},
                               .dimensions = {std::string(name)},
                               .units = std::string(units),
                               .long_name = std::string(long_name),
                               .is_axis = true,
                               .values = values});
    dimensions_.emplace_back(name);
    shape_.push_back(values.size());
  }

  void read_info() {
    if (!text_of(first(), "material") || !text_of(first(), "azimuth_convention"))
      throw BadInput(
          "{}: is an OpenEXR file, but not a table of brdftab: it has no attributes brdf:material and "
          "brdf:azimuth_convention",
          path_.string());
    const auto angle_units = text_of(first(), "angle_units").value_or("");
    add_axis("wavelength", "nm", "wavelength");
    if (!info_.variables.empty()) wavelengths_ = info_.variables.front().values;
    for (const auto& row : axis_table) add_axis(row.name, angle_units, row.long_name);
    for (const Polarization polarization : {Polarization::unpolarized, Polarization::s, Polarization::p}) {
      const auto wavelength = wavelengths_.empty() ? std::nullopt : std::optional(wavelengths_.front());
      if (first().channels().findChannel(exr_channel(polarization, wavelength)))
        info_.variables.push_back({.name = std::string(brdf_name(polarization)),
                                   .type = "float32",
                                   .shape = shape_,
                                   .dimensions = dimensions_,
                                   .units = text_of(first(), "units").value_or(""),
                                   .long_name = brdf_long_name(polarization)});
    }
    std::vector<std::string> integral_dimensions{"theta_i"};
    if (!wavelengths_.empty()) integral_dimensions.insert(integral_dimensions.begin(), "wavelength");
    std::vector<std::string> shown{"units", "angle_units"};
    for (const auto& integral : integral_variables({})) {
      shown.push_back(integral.name);
      const auto text = text_of(first(), integral.name);
      if (!text) continue;
      const auto values = numbers(*text);
      std::vector<std::size_t> shape{values.size()};
      if (!wavelengths_.empty()) shape = {wavelengths_.size(), values.size() / wavelengths_.size()};
      info_.variables.push_back({.name = integral.name,
                                 .type = "float64",
                                 .shape = shape,
                                 .dimensions = integral_dimensions,
                                 .units = "1",
                                 .long_name = integral.long_name,
                                 .values = values});
    }
    for (auto at = first().begin(); at != first().end(); ++at) {
      const std::string_view name = at.name();
      if (!name.starts_with(exr_prefix) || name == exr_slice_theta_i || name == exr_slice_phi_i) continue;
      const std::string plain(name.substr(exr_prefix.size()));
      if (info_.variable(plain) || std::find(shown.begin(), shown.end(), plain) != shown.end()) continue;
      if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&at.attribute()))
        info_.attributes.push_back({plain, text->value()});
      else if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&at.attribute()))
        info_.attributes.push_back({plain, number->value()});
    }
  }

  const std::vector<double>& axis(std::string_view name) const {
    const VariableInfo* variable = info_.variable(name);
    if (!variable) throw FileError("{}: has no attribute brdf:{}", path_.string(), name);
    return variable->values;
  }

  void require_size(const Imf::Header& header, std::size_t width, std::size_t height) const {
    const auto window = header.dataWindow();
    if (window.min.x != 0 || window.min.y != 0 || static_cast<std::size_t>(window.max.x) + 1 != width ||
        static_cast<std::size_t>(window.max.y) + 1 != height)
      throw FileError("{}: an image of {} x {} pixels does not fit the axes, which need {} x {}",
                      path_.string(), window.max.x - window.min.x + 1, window.max.y - window.min.y + 1, width,
                      height);
  }

  void place_slices() {
    const auto &theta_i = axis("theta_i"), &phi_i = axis("phi_i");
    const std::size_t rows = axis("theta_s").size(), columns = axis("phi_s").size();
    phi_i_ = phi_i.size();
    rows_ = rows;
    columns_ = columns;
    if (first().hasType() && first().type() == Imf::TILEDIMAGE) {
      tiles_ = true;
      require_size(first(), columns * phi_i.size(), rows * theta_i.size());
      return;
    }
    slices_.assign(theta_i.size() * phi_i.size(), {});
    for (std::size_t file = 0; file < files_.size(); ++file)
      for (int part = 0; part < files_[file]->parts(); ++part) {
        const Imf::Header& header = files_[file]->header(part);
        const auto i = index_of(theta_i, header, exr_slice_theta_i);
        const auto p = index_of(phi_i, header, exr_slice_phi_i);
        if (!i || !p)
          throw FileError("{}: slice {} has angles that the axes lack", path_.string(), header.name());
        require_size(header, columns, rows);
        Slice& slice = slices_[*i * phi_i.size() + *p];
        if (slice.part >= 0)
          throw FileError("{}: two slices have the angles of {}", path_.string(), header.name());
        slice = {file, part};
      }
    for (std::size_t k = 0; k < slices_.size(); ++k)
      if (slices_[k].part < 0)
        throw FileError("{}: the slice at theta_i = {}, phi_i = {} is missing", path_.string(),
                        shortest(theta_i[k / phi_i.size()]), shortest(phi_i[k % phi_i.size()]));
  }

  static void require_channel(const Imf::Header& header, const std::string& channel, const fs::path& path) {
    const Imf::Channel* found = header.channels().findChannel(channel);
    if (!found || found->type != Imf::FLOAT)
      throw FileError("{}: slice {} has no float channel {}", path.string(),
                      header.hasName() ? header.name() : "", channel);
  }

  void read_slices(const std::string& channel, const Slab& box, std::span<double> samples) {
    std::vector<float> rows(box.theta_s.size() * columns_);
    const std::size_t row_bytes = columns_ * sizeof(float);
    double* to = samples.data();
    for (std::size_t i = box.theta_i.begin; i < box.theta_i.end; ++i)
      for (std::size_t p = box.phi_i.begin; p < box.phi_i.end; ++p) {
        const Slice& slice = slices_[i * phi_i_ + p];
        Imf::InputPart part(*files_[slice.file], slice.part);
        require_channel(part.header(), channel, path_);
        Imf::FrameBuffer frame;
        // The base is where pixel (0, 0) would be.
        frame.insert(channel, Imf::Slice(Imf::FLOAT,
                                         reinterpret_cast<char*>(rows.data()) - box.theta_s.begin * row_bytes,
                                         sizeof(float), row_bytes));
        part.setFrameBuffer(frame);
        part.readPixels(static_cast<int>(box.theta_s.begin), static_cast<int>(box.theta_s.end) - 1);
        to = std::copy(rows.begin(), rows.end(), to);
      }
  }

  void read_tiles(const std::string& channel, const Slab& box, std::span<double> samples) {
    require_channel(first(), channel, path_);
    std::vector<float> tile(rows_ * columns_);
    Imf::TiledInputPart part(*files_.front(), 0);
    if (part.tileXSize() != columns_ || part.tileYSize() != rows_)
      throw FileError("{}: tiles of {} x {} pixels do not fit the axes, which need {} x {}", path_.string(),
                      part.tileXSize(), part.tileYSize(), columns_, rows_);
    Imf::FrameBuffer frame;
    frame.insert(channel, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(tile.data()), sizeof(float),
                                     columns_ * sizeof(float), 1, 1, 0, true, true));
    part.setFrameBuffer(frame);
    double* to = samples.data();
    for (std::size_t i = box.theta_i.begin; i < box.theta_i.end; ++i)
      for (std::size_t p = box.phi_i.begin; p < box.phi_i.end; ++p) {
        part.readTile(static_cast<int>(p), static_cast<int>(i));
        to = std::copy(tile.data() + box.theta_s.begin * columns_, tile.data() + box.theta_s.end * columns_,
                       to);
      }
  }

  fs::path path_;
  std::vector<std::unique_ptr<Imf::MultiPartInputFile>> files_;
  TableInfo info_;
  std::vector<std::string> dimensions_;
  std::vector<std::size_t> shape_;
  std::vector<double> wavelengths_;
  std::vector<Slice> slices_;  // [theta_i][phi_i]
  std::size_t phi_i_ = 0, rows_ = 0, columns_ = 0;
  bool tiles_ = false;
};

}  // namespace

std::unique_ptr<TableReader> open_exr_reader(const fs::path& path) {
  return std::make_unique<ExrReader>(path);
}

}  // namespace brdftab

#include "host/formats/hdf5/hdf5_writer.hpp"

#include <algorithm>
#include <optional>

#include "host/base/error.hpp"
#include "host/base/page_cache_window.hpp"
#include "host/formats/hdf5/hdf5_chunks.hpp"
#include "host/formats/hdf5/hdf5_file.hpp"
#include "host/formats/hdf5/hdf5_view.hpp"
#include "host/table/table_attributes.hpp"
#include "host/table/table_writer.hpp"

namespace brdftab {
namespace {

hid_t stored_type(Precision precision) {
  return precision == Precision::float64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE;
}

hid_t memory_type(Precision precision) {
  return precision == Precision::float64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT;
}

std::uint64_t sample_bytes(const TableContent& content) {
  return content.grid.directions() * content.material.bands().size() * content.polarizations.size() *
         bytes_of(content.precision);
}

// Counts the nodes before a position, in the order of the dataset.
std::uint64_t first_node(hid_t dataset, const std::vector<hsize_t>& position) {
  std::vector<hsize_t> shape(position.size());
  const Hdf5Handle space(H5Dget_space(dataset), "brdf");
  H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  std::uint64_t node = 0;
  for (std::size_t k = 0; k < shape.size(); ++k) node = node * shape[k] + position[k];
  return node;
}

class Hdf5Writer : public TableWriter {
 public:
  Hdf5Writer(const std::filesystem::path& path, const TableContent& content)
      : path_(path),
        precision_(content.precision),
        storage_(content.storage),
        rounding_attributes_(rounding_attributes(content)),
        file_(path, content.storage.layout == Layout::virtual_view ? H5F_LIBVER_V110 : H5F_LIBVER_V18),
        page_cache_(path, sample_bytes(content)) {
    if (storage_.deflate_level > 0)
      chunks_.emplace(content.grid, bytes_of(precision_), storage_.deflate_level);
    file_.write_attributes(content_attributes(content));
    if (content.material.has_wavelengths()) {
      std::vector<double> wavelengths;
      for (const auto& band : content.material.bands()) wavelengths.push_back(*band.wavelength_nm);
      file_.create_scale("wavelength", wavelengths, "nm", "wavelength", "radiation_wavelength");
      dimensions_.push_back("wavelength");
    }
    const Grid& grid = content.dense_grid;
    for (const Axis* axis : {&grid.theta_i, &grid.phi_i, &grid.theta_s, &grid.phi_s}) {
      const auto kind = axis->row().kind;
      file_.create_scale(std::string(axis->row().name), axis->nodes(), "degree", axis->row().long_name,
                         kind == AxisKind::theta_i   ? "angle_of_incidence"
                         : kind == AxisKind::theta_s ? "angle_of_emergence"
                                                     : "");
      dimensions_.emplace_back(axis->row().name);
    }
    stored_dimensions_ = dimensions_;
    if (storage_.layout == Layout::virtual_view) {
      const std::string long_name =
          "azimuth of scatter from that of incidence, phi_s - phi_i; its period is 360 degrees";
      file_.create_scale("phi", content.grid.phi_s.nodes(), "degree", long_name, "");
      stored_dimensions_.erase(stored_dimensions_.end() - 3);
      stored_dimensions_.back() = "phi";
    }
    for (const Polarization polarization : content.polarizations) {
      samples_.push_back(create_samples(polarization));
      if (storage_.layout == Layout::virtual_view) create_view(polarization, grid);
    }
    // After this, a run that is killed leaves a file that opens and whose written part can be read.
    hdf5_check(H5Fflush(file_.id(), H5F_SCOPE_LOCAL), path_.string());
  }

  void write(std::size_t polarization, std::size_t band, const Slab& slab,
             std::span<const std::byte> samples) override {
    const Hdf5Silence silence;
    const Hdf5Handle& dataset = samples_[polarization];
    if (chunks_) {
      const auto position = [&](const Slab& chunk) {
        return coordinates(band, chunk.theta_i.begin, chunk.phi_i.begin, chunk.theta_s.begin, 0);
      };
      chunks_->write(dataset, slab, samples, position);
      return;
    }
    const auto start = coordinates(band, slab.theta_i.begin, slab.phi_i.begin, slab.theta_s.begin, 0);
    const auto count =
        coordinates(1, slab.theta_i.size(), slab.phi_i.size(), slab.theta_s.size(), slab.phi_s);
    const Hdf5Handle space(H5Dget_space(dataset), "brdf");
    hdf5_check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
               "brdf");
    const hsize_t nodes = slab.nodes();
    const Hdf5Handle memory(H5Screate_simple(1, &nodes, nullptr), "brdf");
    hdf5_check(H5Dwrite(dataset, memory_type(precision_), memory, space, H5P_DEFAULT, samples.data()),
               path_.string());
    const haddr_t begin = H5Dget_offset(dataset);
    if (begin != HADDR_UNDEF)
      page_cache_.written(begin + first_node(dataset, start) * bytes_of(precision_), samples.size());
  }

  void finish(const TableFindings& findings) override {
    const Hdf5Silence silence;
    write_integrals(findings.integrals);
    file_.write_attributes(findings_attributes(findings));
    samples_.clear();
    file_.close();
  }

 private:
  // Gives a node's indices, or a box's extents, in the dimensions that the samples have.
  std::vector<hsize_t> coordinates(hsize_t wavelength, hsize_t theta_i, hsize_t phi_i, hsize_t theta_s,
                                   hsize_t phi_s) const {
    std::vector<hsize_t> result{theta_i, theta_s, phi_s};
    if (storage_.layout == Layout::contiguous) result.insert(result.begin() + 1, phi_i);
    if (dimensions_.size() == 5) result.insert(result.begin(), wavelength);
    return result;
  }

  // Each variable has one value for each theta_i, and for each wavelength where there are any.
  void write_integrals(const std::vector<Integrals>& bands) {
    std::vector<std::string> dimensions{"theta_i"};
    if (dimensions_.size() == 5) dimensions.insert(dimensions.begin(), "wavelength");
    for (const auto& integral : integral_variables(bands)) {
      const Hdf5Handle variable = file_.create_variable(integral.name, dimensions, H5T_IEEE_F64LE, "1",
                                                        integral.long_name, hdf5_dataset_properties());
      hdf5_check(H5Dwrite(variable, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, integral.values.data()),
                 path_.string());
    }
  }

  Hdf5Handle create_brdf(Polarization polarization, const std::string& name,
                         const std::vector<std::string>& dimensions, const Hdf5Handle& creation) {
    Hdf5Handle dataset = file_.create_variable(name, dimensions, stored_type(precision_), "sr-1",
                                               brdf_long_name(polarization), creation);
    brdftab::write_attributes(dataset, rounding_attributes_);
    return dataset;
  }

  std::string stored_name(Polarization polarization) const {
    return fmt::format("{}{}", brdf_name(polarization),
                       storage_.layout == Layout::virtual_view ? "_relative" : "");
  }

  Hdf5Handle create_samples(Polarization polarization) {
    return create_brdf(polarization, stored_name(polarization), stored_dimensions_, sample_storage());
  }

  void create_view(Polarization polarization, const Grid& grid) {
    const Hdf5Handle creation = hdf5_dataset_properties();
    set_view(creation, file_.shape_of(dimensions_), stored_name(polarization),
             file_.shape_of(stored_dimensions_), relative_azimuth(grid.phi_i, grid.phi_s).pieces);
    create_brdf(polarization, std::string(brdf_name(polarization)), dimensions_, creation);
  }

  // Every node is written, so nothing is filled. What is not compressed is contiguous and allocated at once.
  Hdf5Handle sample_storage() const {
    Hdf5Handle creation = hdf5_dataset_properties();
    hdf5_check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), "fill time");
    if (chunks_) {
      const Chunk& chunk = chunks_->shape();
      chunks_->set_filters(creation, coordinates(1, chunk.theta_i, chunk.phi_i, chunk.theta_s,
                                                 file_.shape_of(stored_dimensions_).back()));
    } else {
      hdf5_check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), "allocation time");
    }
    return creation;
  }

  std::filesystem::path path_;
  Precision precision_;
  TableStorage storage_;
  std::vector<AttributeInfo> rounding_attributes_;
  Hdf5File file_;
  PageCacheWindow page_cache_;
  std::vector<std::string> dimensions_;
  std::vector<std::string> stored_dimensions_;
  std::vector<Hdf5Handle> samples_;
  std::optional<Hdf5Chunks> chunks_;
};

}  // namespace

std::unique_ptr<TableWriter> create_hdf5_writer(const std::filesystem::path& file,
                                                const TableContent& content) {
  const Hdf5Silence silence;
  return std::make_unique<Hdf5Writer>(file, content);
}

}  // namespace brdftab

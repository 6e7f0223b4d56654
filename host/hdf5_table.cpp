#include "host/hdf5_table.hpp"

#include <hdf5_hl.h>

#include <map>

#include "host/error.hpp"
#include "host/hdf5_handle.hpp"
#include "host/table_attributes.hpp"

namespace brdftab {
namespace {

hid_t stored_type(Precision precision) { return precision == Precision::float64 ? H5T_IEEE_F64LE : H5T_IEEE_F32LE; }

hid_t memory_type(Precision precision) { return precision == Precision::float64 ? H5T_NATIVE_DOUBLE : H5T_NATIVE_FLOAT; }

// netCDF and h5netcdf keep the order of creation, and can append, only if the root tracks it.
Hdf5Handle create_file(const std::filesystem::path& path) {
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), "HDF5 file properties");
  const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  hdf5_check(H5Pset_link_creation_order(creation, order), "link order");
  hdf5_check(H5Pset_attr_creation_order(creation, order), "attribute order");
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "HDF5 file properties");
  // Since 1.8 an attribute may exceed 64 KiB, as a material's text may.
  hdf5_check(H5Pset_libver_bounds(access, H5F_LIBVER_V18, H5F_LIBVER_V18), "HDF5 version");
  return Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation, access), path.string());
}

class Hdf5Table : public TableWriter {
 public:
  Hdf5Table(const std::filesystem::path& path, const TableContent& content)
      : path_(path), precision_(content.precision), file_(create_file(path)) {
    write_attributes(Hdf5Handle(H5Gopen2(file_, "/", H5P_DEFAULT), path_.string()), content_attributes(content));
    if (content.material.has_wavelengths()) {
      std::vector<double> wavelengths;
      for (const auto& band : content.material.bands()) wavelengths.push_back(*band.wavelength_nm);
      create_scale("wavelength", wavelengths, "nm", "wavelength", "radiation_wavelength");
      dimensions_.push_back("wavelength");
    }
    const Grid& grid = content.grid;
    for (const Axis* axis : {&grid.theta_i, &grid.phi_i, &grid.theta_s, &grid.phi_s}) {
      const auto kind = axis->row().kind;
      create_scale(std::string(axis->row().name), axis->nodes(), "degree", axis->row().long_name,
                   kind == AxisKind::theta_i   ? "angle_of_incidence"
                   : kind == AxisKind::theta_s ? "angle_of_emergence"
                                               : "");
      dimensions_.emplace_back(axis->row().name);
    }
    for (const Polarization polarization : content.polarizations)
      samples_.push_back(create_variable(std::string(brdf_name(polarization)), dimensions_, stored_type(precision_), "sr-1",
                                         brdf_long_name(polarization)));
    // A killed run leaves a file that opens and whose written part reads.
    hdf5_check(H5Fflush(file_, H5F_SCOPE_LOCAL), path_.string());
  }

  void write(std::size_t polarization, std::size_t band, const Slab& slab, std::span<const std::byte> samples) override {
    std::vector<hsize_t> start{slab.theta_i.begin, slab.phi_i.begin, slab.theta_s.begin, 0};
    std::vector<hsize_t> count{slab.theta_i.size(), slab.phi_i.size(), slab.theta_s.size(), slab.phi_s};
    if (dimensions_.size() == 5) {
      start.insert(start.begin(), band);
      count.insert(count.begin(), 1);
    }
    const Hdf5Handle& dataset = samples_[polarization];
    const Hdf5Handle space(H5Dget_space(dataset), "brdf");
    hdf5_check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr), "brdf");
    const hsize_t nodes = slab.nodes();
    const Hdf5Handle memory(H5Screate_simple(1, &nodes, nullptr), "brdf");
    hdf5_check(H5Dwrite(dataset, memory_type(precision_), memory, space, H5P_DEFAULT, samples.data()), path_.string());
  }

  void finish(const TableFindings& findings) override {
    write_integrals(findings.integrals);
    Hdf5Handle root(H5Gopen2(file_, "/", H5P_DEFAULT), path_.string());
    write_attributes(root, findings_attributes(findings));
    root = Hdf5Handle();
    scales_.clear();
    samples_.clear();
    file_.close(path_.string());
  }

 private:
  // One value for each theta_i, and for each wavelength where there are any.
  void write_integrals(const std::vector<Integrals>& bands) {
    std::vector<std::string> dimensions{"theta_i"};
    if (dimensions_.size() == 5) dimensions.insert(dimensions.begin(), "wavelength");
    for (const auto& integral : integral_variables(bands)) {
      const Hdf5Handle variable = create_variable(integral.name, dimensions, H5T_IEEE_F64LE, "1", integral.long_name);
      hdf5_check(H5Dwrite(variable, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, integral.values.data()), path_.string());
    }
  }

  void write_attributes(hid_t root, const std::vector<AttributeInfo>& attributes) {
    for (const auto& attribute : attributes)
      std::visit([&](const auto& value) { write_attribute(root, attribute.name, value); }, attribute.value);
  }

  void create_scale(const std::string& name, std::span<const double> nodes, std::string_view units, std::string_view long_name,
                    std::string_view standard_name) {
    const hsize_t count = nodes.size();
    const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), name);
    Hdf5Handle dataset(H5Dcreate2(file_, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    hdf5_check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, nodes.data()), path_.string());
    hdf5_check(H5DSset_scale(dataset, name.c_str()), name);
    write_attribute(dataset, "units", units);
    write_attribute(dataset, "long_name", long_name);
    if (!standard_name.empty()) write_attribute(dataset, "standard_name", standard_name);
    sizes_[name] = count;
    scales_.emplace(name, std::move(dataset));
  }

  // Contiguous, allocated now and never filled: every node is written.
  Hdf5Handle create_variable(const std::string& name, const std::vector<std::string>& dimensions, hid_t type,
                             std::string_view units, const std::string& long_name) {
    std::vector<hsize_t> shape;
    for (const auto& dimension : dimensions) shape.push_back(sizes_.at(dimension));
    const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), name);
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), name);
    hdf5_check(H5Pset_alloc_time(creation, H5D_ALLOC_TIME_EARLY), name);
    hdf5_check(H5Pset_fill_time(creation, H5D_FILL_TIME_NEVER), name);
    Hdf5Handle dataset(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT), path_.string());
    for (unsigned k = 0; k < dimensions.size(); ++k) hdf5_check(H5DSattach_scale(dataset, scales_.at(dimensions[k]), k), name);
    write_attribute(dataset, "units", units);
    write_attribute(dataset, "long_name", long_name);
    return dataset;
  }

  std::filesystem::path path_;
  Precision precision_;
  Hdf5Handle file_;
  std::vector<std::string> dimensions_;
  std::map<std::string, hsize_t> sizes_;
  std::map<std::string, Hdf5Handle> scales_;
  std::vector<Hdf5Handle> samples_;
};

}  // namespace

std::unique_ptr<TableWriter> create_hdf5_table(const std::filesystem::path& file, const TableContent& content) {
  hdf5_quiet();
  return std::make_unique<Hdf5Table>(file, content);
}

}  // namespace brdftab

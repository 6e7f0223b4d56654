#include "host/formats/hdf5/hdf5_file.hpp"

#include <hdf5_hl.h>

namespace brdftab {
namespace {

// netCDF and h5netcdf keep the order of creation, and can append, only if the root tracks it.
Hdf5Handle create_file(const std::filesystem::path& path, H5F_libver_t oldest) {
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), "HDF5 file properties");
  const unsigned order = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  hdf5_check(H5Pset_link_creation_order(creation, order), "link order");
  hdf5_check(H5Pset_attr_creation_order(creation, order), "attribute order");
  // Without times the same table is the same bytes, whenever it is made.
  hdf5_check(H5Pset_obj_track_times(creation, false), "object times");
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), "HDF5 file properties");
  // Since 1.8 an attribute may exceed 64 KiB, as one value for each of many wavelengths may. Views, and a
  // short form of the strided selections that they may take, came with 1.10.
  hdf5_check(H5Pset_libver_bounds(access, oldest, oldest), "HDF5 version");
  // The file is made anew, not truncated: ext4 takes a truncated file for one that replaces another, and
  // flushes it when it is closed.
  std::filesystem::remove(path);
  return Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation, access), path.string());
}

}  // namespace

Hdf5Handle hdf5_dataset_properties() {
  Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), "dataset properties");
  hdf5_check(H5Pset_obj_track_times(creation, false), "object times");
  return creation;
}

void write_attributes(hid_t object, const std::vector<AttributeInfo>& attributes) {
  for (const auto& attribute : attributes)
    std::visit([&](const auto& value) { write_attribute(object, attribute.name, value); }, attribute.value);
}

Hdf5File::Hdf5File(const std::filesystem::path& path, H5F_libver_t oldest)
    : path_(path), file_(create_file(path, oldest)) {}

void Hdf5File::write_attributes(const std::vector<AttributeInfo>& attributes) {
  brdftab::write_attributes(Hdf5Handle(H5Gopen2(file_, "/", H5P_DEFAULT), path_.string()), attributes);
}

void Hdf5File::create_scale(const std::string& name, std::span<const double> nodes, std::string_view units,
                            std::string_view long_name, std::string_view standard_name) {
  const hsize_t count = nodes.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), name);
  Hdf5Handle dataset(H5Dcreate2(file_, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT,
                                hdf5_dataset_properties(), H5P_DEFAULT),
                     name);
  hdf5_check(H5Dwrite(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, nodes.data()),
             path_.string());
  hdf5_check(H5DSset_scale(dataset, name.c_str()), name);
  write_attribute(dataset, "units", units);
  write_attribute(dataset, "long_name", long_name);
  if (!standard_name.empty()) write_attribute(dataset, "standard_name", standard_name);
  sizes_[name] = count;
  scales_.emplace(name, std::move(dataset));
}

Hdf5Handle Hdf5File::create_variable(const std::string& name, const std::vector<std::string>& dimensions,
                                     hid_t type, std::string_view units, const std::string& long_name,
                                     const Hdf5Handle& creation) const {
  const std::vector<hsize_t> shape = shape_of(dimensions);
  const Hdf5Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), name);
  Hdf5Handle dataset(H5Dcreate2(file_, name.c_str(), type, space, H5P_DEFAULT, creation, H5P_DEFAULT),
                     path_.string());
  for (unsigned k = 0; k < dimensions.size(); ++k)
    hdf5_check(H5DSattach_scale(dataset, scales_.at(dimensions[k]), k), name);
  write_attribute(dataset, "units", units);
  write_attribute(dataset, "long_name", long_name);
  return dataset;
}

std::vector<hsize_t> Hdf5File::shape_of(const std::vector<std::string>& dimensions) const {
  std::vector<hsize_t> shape;
  for (const auto& dimension : dimensions) shape.push_back(sizes_.at(dimension));
  return shape;
}

void Hdf5File::close() {
  scales_.clear();
  file_.close(path_.string());
}

}  // namespace brdftab

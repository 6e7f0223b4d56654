#include "host/formats/hdf5/hdf5_reader.hpp"

#include <hdf5_hl.h>

#include <algorithm>

#include "host/base/error.hpp"
#include "host/formats/hdf5/hdf5_handle.hpp"
#include "host/formats/hdf5/hdf5_storage.hpp"
#include "host/table/table_reader.hpp"

namespace brdftab {
namespace {

std::vector<std::size_t> shape_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> sizes(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, sizes.data(), nullptr);
  return {sizes.begin(), sizes.end()};
}

std::vector<std::string> names_of(hid_t object, H5_index_t index, bool attributes) {
  std::vector<std::string> names;
  hsize_t at = 0;
  if (attributes)
    H5Aiterate2(
        object, index, H5_ITER_INC, &at,
        [](hid_t, const char* name, const H5A_info_t*, void* out) -> herr_t {
          static_cast<std::vector<std::string>*>(out)->emplace_back(name);
          return 0;
        },
        &names);
  else
    H5Literate(
        object, index, H5_ITER_INC, &at,
        [](hid_t, const char* name, const H5L_info_t*, void* out) -> herr_t {
          static_cast<std::vector<std::string>*>(out)->emplace_back(name);
          return 0;
        },
        &names);
  return names;
}

std::vector<AttributeInfo> attributes_of(hid_t object) {
  std::vector<AttributeInfo> attributes;
  for (const auto& name : names_of(object, H5_INDEX_CRT_ORDER, true)) {
    const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), name);
    const Hdf5Handle type(H5Aget_type(attribute), name);
    const Hdf5Handle space(H5Aget_space(attribute), name);
    if (has_text_attribute(object, name)) {
      attributes.push_back({name, read_text_attribute(object, name)});
    } else if (H5Tget_class(type) == H5T_FLOAT || H5Tget_class(type) == H5T_INTEGER) {
      const auto shape = shape_of(space);
      std::vector<double> values(
          static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space), 0)));
      hdf5_check(H5Aread(attribute, H5T_NATIVE_DOUBLE, values.data()), name);
      if (shape.empty())
        attributes.push_back({name, values[0]});
      else
        attributes.push_back({name, values});
    }
  }
  return attributes;
}

std::vector<std::string> dimensions_of(hid_t dataset, std::size_t rank) {
  std::vector<std::string> names;
  for (unsigned k = 0; k < rank; ++k) {
    std::string name;
    H5DSiterate_scales(
        dataset, k, nullptr,
        [](hid_t, unsigned, hid_t scale, void* out) -> herr_t {
          char text[256] = "";
          H5DSget_scale_name(scale, text, sizeof text);
          *static_cast<std::string*>(out) = text;
          return 1;
        },
        &name);
    names.push_back(name);
  }
  return names;
}

std::string type_name(hid_t type) {
  const bool floating = H5Tget_class(type) == H5T_FLOAT;
  return fmt::format("{}{}", floating ? "float" : "other", 8 * H5Tget_size(type));
}

VariableInfo variable_of(hid_t file, const std::string& name) {
  const Hdf5Handle dataset(H5Dopen2(file, name.c_str(), H5P_DEFAULT), name);
  const Hdf5Handle space(H5Dget_space(dataset), name);
  const Hdf5Handle type(H5Dget_type(dataset), name);
  VariableInfo variable{
      .name = name,
      .type = type_name(type),
      .shape = shape_of(space),
      .dimensions = {},
      .units = has_text_attribute(dataset, "units") ? read_text_attribute(dataset, "units") : "",
      .long_name = has_text_attribute(dataset, "long_name") ? read_text_attribute(dataset, "long_name") : "",
      .is_axis = H5DSis_scale(dataset) > 0,
      .values = {},
      .storage = storage_of(dataset)};
  variable.dimensions = variable.is_axis ? std::vector{name} : dimensions_of(dataset, variable.shape.size());
  const bool numeric = H5Tget_class(type) == H5T_FLOAT || H5Tget_class(type) == H5T_INTEGER;
  if (numeric && (variable.shape.size() == 1 || variable.shape.size() == 2)) {
    variable.values.resize(variable.shape.size() == 1 ? variable.shape[0]
                                                      : variable.shape[0] * variable.shape[1]);
    hdf5_check(H5Dread(dataset, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, variable.values.data()),
               name);
  }
  return variable;
}

/// A link that leads nowhere is no dataset; an object that cannot be opened is damage. H5Oget_info_by_name
/// would tell as well, but has another signature in each release of HDF5.
bool is_dataset(hid_t file, const std::string& name) {
  if (H5Oexists_by_name(file, name.c_str(), H5P_DEFAULT) <= 0) return false;
  const Hdf5Handle object(H5Oopen(file, name.c_str(), H5P_DEFAULT), name);
  return H5Iget_type(object) == H5I_DATASET;
}

class Hdf5Reader : public TableReader {
 public:
  explicit Hdf5Reader(const std::filesystem::path& path)
      : path_(path),
        file_(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), path.string() + ": is damaged") {
    const Hdf5Handle root(H5Gopen2(file_, "/", H5P_DEFAULT), path.string());
    if (!has_text_attribute(root, "material") || !has_text_attribute(root, "azimuth_convention"))
      throw BadInput(
          "{}: is an HDF5 file, but not a table of brdftab: it has no attributes material and "
          "azimuth_convention",
          path.string());
    info_.attributes = attributes_of(root);
    for (const auto& name : names_of(root, H5_INDEX_CRT_ORDER, false))
      if (is_dataset(file_, name)) info_.variables.push_back(variable_of(file_, name));
  }

  const TableInfo& info() const override { return info_; }

  void read(Polarization polarization, std::size_t band, const Slab& box,
            std::span<double> samples) override {
    const Hdf5Silence silence;
    const std::string name(brdf_name(polarization));
    const Hdf5Handle dataset(H5Dopen2(file_, name.c_str(), H5P_DEFAULT), name);
    const Hdf5Handle space(H5Dget_space(dataset), name);
    std::vector<hsize_t> start{box.theta_i.begin, box.phi_i.begin, box.theta_s.begin, 0};
    std::vector<hsize_t> count{box.theta_i.size(), box.phi_i.size(), box.theta_s.size(), box.phi_s};
    if (H5Sget_simple_extent_ndims(space) == 5) {
      start.insert(start.begin(), band);
      count.insert(count.begin(), 1);
    }
    hdf5_check(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr),
               name);
    const hsize_t nodes = box.nodes();
    const Hdf5Handle memory(H5Screate_simple(1, &nodes, nullptr), name);
    hdf5_check(H5Dread(dataset, H5T_NATIVE_DOUBLE, memory, space, H5P_DEFAULT, samples.data()),
               fmt::format("{}: samples of {} are damaged", path_.string(), name));
  }

 private:
  std::filesystem::path path_;
  Hdf5Handle file_;
  TableInfo info_;
};

}  // namespace

std::unique_ptr<TableReader> open_hdf5_reader(const std::filesystem::path& file) {
  const Hdf5Silence silence;
  return std::make_unique<Hdf5Reader>(file);
}

}  // namespace brdftab

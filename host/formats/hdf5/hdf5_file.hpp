// A new HDF5 file has root-level datasets with named axes, as netCDF, h5py and MATLAB see them.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/formats/hdf5/hdf5_handle.hpp"
#include "host/table/attribute.hpp"

namespace brdftab {

/// Gives the properties of a dataset that is the same, byte for byte, whenever it is made.
Hdf5Handle hdf5_dataset_properties();

void write_attributes(hid_t object, const std::vector<AttributeInfo>& attributes);

class Hdf5File {
 public:
  /// `oldest` names the oldest library that is to read the file. Throws FileError.
  Hdf5File(const std::filesystem::path& path, H5F_libver_t oldest);

  hid_t id() const { return file_; }

  /// Writes them to the root.
  void write_attributes(const std::vector<AttributeInfo>& attributes);

  /// Creates a coordinate variable of float64. `standard_name` is that of the CF conventions, and empty where
  /// they have none.
  void create_scale(const std::string& name, std::span<const double> nodes, std::string_view units,
                    std::string_view long_name, std::string_view standard_name);

  /// Creates a dataset over coordinate variables that were made before; its samples are not yet written.
  Hdf5Handle create_variable(const std::string& name, const std::vector<std::string>& dimensions, hid_t type,
                             std::string_view units, const std::string& long_name,
                             const Hdf5Handle& creation) const;

  std::vector<hsize_t> shape_of(const std::vector<std::string>& dimensions) const;

  /// To be called once all datasets are closed. Throws FileError.
  void close();

 private:
  std::filesystem::path path_;
  Hdf5Handle file_;
  std::map<std::string, hsize_t> sizes_;
  std::map<std::string, Hdf5Handle> scales_;
};

}  // namespace brdftab

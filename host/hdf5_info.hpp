// What an HDF5 table holds, read back from the file.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/attribute.hpp"

namespace brdftab {

struct VariableInfo {
  std::string name;
  std::string type;  // float32 or float64
  std::vector<std::size_t> shape;
  std::vector<std::string> dimensions;
  std::string units;
  std::string long_name;
  bool is_axis;
  std::vector<double> values;  // of one-dimensional variables
};

struct TableInfo {
  std::vector<VariableInfo> variables;  // in the file's order
  std::vector<AttributeInfo> attributes;
};

/// Throws FileError where the file cannot be read, and BadInput where it is not a table of this program.
TableInfo read_hdf5_info(const std::filesystem::path& file);

}  // namespace brdftab

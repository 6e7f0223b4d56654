// What an HDF5 table holds, read back from the file.
#pragma once

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "host/hdf5_storage.hpp"

namespace brdftab {

using AttributeValue = std::variant<std::string, double, std::vector<double>>;

struct AttributeInfo {
  std::string name;
  AttributeValue value;
};

struct VariableInfo {
  std::string name;
  std::string type;  // float32 or float64
  std::vector<std::size_t> shape;
  std::vector<std::string> dimensions;
  std::string units;
  std::string long_name;
  bool is_axis;
  std::vector<double> values;  // of one-dimensional variables
  Hdf5Storage storage;
};

struct TableInfo {
  std::vector<VariableInfo> variables;  // in the file's order
  std::vector<AttributeInfo> attributes;
};

/// Throws FileError where the file cannot be read, and BadInput where it is not a table of this program.
TableInfo read_hdf5_info(const std::filesystem::path& file);

}  // namespace brdftab

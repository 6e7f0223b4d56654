// A table read back from its file, whatever its format.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/compute/slab.hpp"
#include "host/formats/hdf5/hdf5_storage.hpp"
#include "host/model/polarization.hpp"
#include "host/table/attribute.hpp"

namespace brdftab {

struct VariableInfo {
  std::string name;
  std::string type;  // float32 or float64
  std::vector<std::size_t> shape;
  std::vector<std::string> dimensions;
  std::string units;
  std::string long_name;
  bool is_axis = false;
  std::vector<double> values;  // of variables of one or two dimensions; nan where a value is no number
  std::optional<Hdf5Storage> storage;  // of variables of an HDF5 file
};

/// What a file says it holds; nothing of it has been checked against anything else.
struct TableInfo {
  std::vector<VariableInfo> variables;  // in the file's order
  std::vector<AttributeInfo> attributes;

  /// Null where there is none.
  const VariableInfo* variable(std::string_view name) const;
  const AttributeValue* attribute(std::string_view name) const;
};

class TableReader {
 public:
  virtual ~TableReader() = default;

  virtual const TableInfo& info() const = 0;

  /// Samples of a box of nodes, [theta_i][phi_i][theta_s][phi_s], from the variable of a polarisation that
  /// `info` lists. Throws FileError where the file does not have them whole.
  virtual void read(Polarization polarization, std::size_t band, const Slab& box,
                    std::span<double> samples) = 0;
};

/// Opens by the file's first bytes; a folder holds the slices of an OpenEXR table. Throws FileError where it
/// cannot be read, a truncated one included, and BadInput where it is not a table of this program.
std::unique_ptr<TableReader> open_table(const std::filesystem::path& path);

/// Whether a file is to be opened as a table: a folder, what is named as one, or begins as HDF5 or OpenEXR
/// does; "-" is not.
bool is_table(const std::filesystem::path& file);

}  // namespace brdftab

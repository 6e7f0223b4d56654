// A table read back from its file, whatever its format.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/compute/slab.hpp"
#include "host/model/polarization.hpp"
#include "host/table/attribute.hpp"
#include "host/table/storage_info.hpp"

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
  std::optional<StorageInfo> storage;  // none where the format leaves no choice
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

}  // namespace brdftab

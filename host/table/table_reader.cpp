#include "host/table/table_reader.hpp"

#include <algorithm>

namespace brdftab {

const VariableInfo* TableInfo::variable(std::string_view name) const {
  const auto at =
      std::find_if(variables.begin(), variables.end(), [&](const auto& v) { return v.name == name; });
  return at == variables.end() ? nullptr : &*at;
}

const AttributeValue* TableInfo::attribute(std::string_view name) const {
  const auto at =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.name == name; });
  return at == attributes.end() ? nullptr : &at->value;
}

}  // namespace brdftab

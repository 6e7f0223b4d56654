// A named value of a table, as any format can hold it.
#pragma once

#include <string>
#include <variant>
#include <vector>

namespace brdftab {

using AttributeValue = std::variant<std::string, double, std::vector<double>>;

struct AttributeInfo {
  std::string name;
  AttributeValue value;
};

}  // namespace brdftab

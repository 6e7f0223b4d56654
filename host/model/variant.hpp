// The names of the model's variants, as files spell them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/model/parameters.hpp"

namespace brdftab {

/// A switch of `[model]`: its choices in the order of its enumeration, the default first.
struct VariantRow {
  std::string_view name;
  std::vector<std::string_view> choices;
  std::string_view meaning;
  int (*get)(const Variant&);
  void (*set)(Variant&, int choice);
  /// true and false are booleans in the file, not strings.
  bool is_boolean() const { return choices.front() == "true"; }
};

const std::vector<VariantRow>& variant_table();

/// Names the choice in force.
std::string_view choice_name(const VariantRow& row, const Variant& variant);

}  // namespace brdftab

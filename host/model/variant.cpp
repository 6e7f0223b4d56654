#include "host/model/variant.hpp"

namespace brdftab {
namespace {

template <auto member>
int get(const Variant& variant) {
  return static_cast<int>(variant.*member);
}

template <auto member>
void set(Variant& variant, int choice) {
  using Value = std::remove_reference_t<decltype(variant.*member)>;
  variant.*member = static_cast<Value>(choice);
}

// A boolean's first choice is true.
template <auto member>
int get_flag(const Variant& variant) {
  return variant.*member ? 0 : 1;
}

template <auto member>
void set_flag(Variant& variant, int choice) {
  variant.*member = choice == 0;
}

}  // namespace

const std::vector<VariantRow>& variant_table() {
  static const std::vector<VariantRow> table{
      {"normalization",
       {"hemispherical", "reciprocal", "closed-form"},
       "N of a lobe: its integral at θ_i; sqrt(N(θ_i) N(θ_s)); or Eq. (8), with constant ρ",
       get<&Variant::normalization>,
       set<&Variant::normalization>},
      {"autocovariance",
       {"lorentzian", "gaussian"},
       "profile of a lobe: Eq. (4), or Eq. (2)",
       get<&Variant::autocovariance>,
       set<&Variant::autocovariance>},
      {"foreshortening",
       {"true", "false"},
       "ρ' shrinks with (cos θ_i + cos θ_s)/2, Eq. (9)",
       get_flag<&Variant::foreshortening>,
       set_flag<&Variant::foreshortening>},
      {"width_shadowing",
       {"true", "false"},
       "ρ' shrinks with V(sin θ_i) V(sin θ_s), Eq. (12)",
       get_flag<&Variant::width_shadowing>,
       set_flag<&Variant::width_shadowing>},
      {"reflectance_shadowing",
       {"all", "surface", "none"},
       "lobes that V_m of Eq. (13) multiplies",
       get<&Variant::reflectance_shadowing>,
       set<&Variant::reflectance_shadowing>},
  };
  return table;
}

std::string_view choice_name(const VariantRow& row, const Variant& variant) {
  return row.choices[static_cast<std::size_t>(row.get(variant))];
}

}  // namespace brdftab

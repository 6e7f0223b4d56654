#include "host/model/variant.hpp"

namespace brdftab {
namespace {

template <auto member>
int get(const ModelSwitches& switches) {
  return static_cast<int>(switches.*member);
}

template <auto member>
void set(ModelSwitches& switches, int choice) {
  using Value = std::remove_reference_t<decltype(switches.*member)>;
  switches.*member = static_cast<Value>(choice);
}

// A boolean's first choice is true.
template <auto member>
int get_flag(const ModelSwitches& switches) {
  return switches.*member ? 0 : 1;
}

template <auto member>
void set_flag(ModelSwitches& switches, int choice) {
  switches.*member = choice == 0;
}

}  // namespace

const std::vector<SwitchRow>& switch_table() {
  static const std::vector<SwitchRow> table{
      {"normalization",
       {"hemispherical", "reciprocal", "closed-form"},
       "N of a lobe: its integral at θ_i; sqrt(N(θ_i) N(θ_s)); or Eq. (8), with constant ρ",
       get<&ModelSwitches::normalization>,
       set<&ModelSwitches::normalization>},
      {"autocovariance",
       {"lorentzian", "gaussian"},
       "profile of a lobe: Eq. (4), or Eq. (2)",
       get<&ModelSwitches::autocovariance>,
       set<&ModelSwitches::autocovariance>},
      {"foreshortening",
       {"true", "false"},
       "ρ' shrinks with (cos θ_i + cos θ_s)/2, Eq. (9)",
       get_flag<&ModelSwitches::foreshortening>,
       set_flag<&ModelSwitches::foreshortening>},
      {"width_shadowing",
       {"true", "false"},
       "ρ' shrinks with V(sin θ_i) V(sin θ_s), Eq. (12)",
       get_flag<&ModelSwitches::width_shadowing>,
       set_flag<&ModelSwitches::width_shadowing>},
      {"reflectance_shadowing",
       {"all", "surface", "none"},
       "lobes that V_m of Eq. (13) multiplies",
       get<&ModelSwitches::reflectance_shadowing>,
       set<&ModelSwitches::reflectance_shadowing>},
  };
  return table;
}

std::string_view choice_name(const SwitchRow& row, const ModelSwitches& switches) {
  return row.choices[static_cast<std::size_t>(row.get(switches))];
}

}  // namespace brdftab

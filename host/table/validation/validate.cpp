#include "host/table/validation/validate.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/statistics.hpp"
#include "host/table/table_attributes.hpp"
#include "host/table/validation/misreading.hpp"
#include "host/table/validation/spot_check.hpp"

namespace brdftab {
namespace {

// Largest relative errors that stored integrals promise; see the README's table of accuracy.
constexpr double promised_normalization = 1e-10;
constexpr double promised_dhr = 1e-8;
constexpr double promised_normalization_float32 = 1e-5;
constexpr double promised_dhr_float32 = 1e-3;
// The reference takes tens of milliseconds for the DHR of one theta_i.
constexpr std::size_t reference_dhr_angles = 3;
constexpr std::size_t reference_normalization_angles = 16;
constexpr std::size_t reciprocity_angles = 24;
// Above this share of wrong nodes the file is misread rather than damaged.
constexpr double mostly = 0.1;

double relative(double stored, double expected) {
  if (stored == expected) return 0;
  const double error = std::abs(stored - expected) / std::max(std::abs(expected), 1e-300);
  return std::isfinite(error) ? error : INFINITY;
}

class Validator {
 public:
  Validator(const Engine& engine, TableReader& reader, const StoredTable& table,
            const ValidateOptions& options)
      : engine_(engine), reader_(reader), table_(table), options_(options) {
    result_.tolerance = options.tolerance.value_or(table.promised);
    result_.faults = table.faults;
    for (const Band& band : table.material.bands()) {
      integrals_.push_back(integrals(engine, band, table.material.variant(), table.grid.theta_i.nodes()));
      plans_.emplace_back(engine, table.material, band, table.grid, integrals_.back());
      models_.emplace_back(band.parameters, table.material.variant());
    }
  }

  Validation run() {
    check_samples();
    check_integrals();
    check_energy();
    check_reciprocity();
    // A table that is not the material's has no interpolation error to speak of.
    if (result_.faults.empty()) {
      const AttributeValue* floor = reader_.info().attribute("interpolation_floor");
      const auto* share = floor ? std::get_if<double>(floor) : nullptr;
      result_.interpolation = interpolation_errors(engine_, reader_, table_, share ? *share : 0);
    }
    return std::move(result_);
  }

 private:
  template <class... Args>
  void fault(fmt::format_string<Args...> format, Args&&... args) {
    result_.faults.push_back(fmt::format(format, std::forward<Args>(args)...));
  }

  void check_samples() {
    const NodeFindings& nodes = result_.nodes =
        check_nodes(engine_, plans_, models_, reader_, table_, result_.tolerance, options_.nodes);
    if (nodes.not_finite + nodes.negative > 0)
      fault("{} nodes are not finite and {} are negative, the first {} at {}", nodes.not_finite,
            nodes.negative, shortest(nodes.first_bad->stored), describe(table_, *nodes.first_bad));
    if (!nodes.worst || nodes.max_relative_error <= result_.tolerance) return;
    const double share = static_cast<double>(nodes.over_tolerance) / static_cast<double>(nodes.nodes);
    const std::string misreading =
        share > mostly ? find_misreading(models_, reader_, table_, std::max(1e-5, 10 * result_.tolerance))
                       : "";
    const std::string worst =
        fmt::format("the worst has {} where the reference has {}, a relative error of {:.2e}, at {}",
                    shortest(nodes.worst->stored), shortest(nodes.worst->expected), nodes.max_relative_error,
                    describe(table_, *nodes.worst));
    if (!misreading.empty())
      fault(
          "{}: read so, the samples are those of the material; as the file stands, {} of {} nodes differ "
          "from the reference by more than {:.1e}: {}",
          misreading, nodes.over_tolerance, nodes.nodes, result_.tolerance, worst);
    else if (share > mostly)
      fault(
          "the samples are not those of the material's text on these axes: {} of {} nodes differ from the "
          "reference by more than {:.1e}: {}",
          nodes.over_tolerance, nodes.nodes, result_.tolerance, worst);
    else
      fault(
          "{} of {} nodes differ from the reference by more than {:.1e}, as if changed after the table was "
          "made: {}",
          std::max<std::size_t>(nodes.over_tolerance, 1), nodes.nodes, result_.tolerance, worst);
  }

  // All stored values against the kernels', some against the reference.
  void check_integrals() {
    const auto expected = integral_variables(integrals_);
    const std::size_t angles = table_.grid.theta_i.size();
    for (std::size_t v = 0; v < expected.size(); ++v) {
      const auto& stored = reader_.info().variable(expected[v].name)->values;
      for (std::size_t k = 0; k < stored.size(); ++k)
        record(expected[v].name, k % angles, stored[k], expected[v].values[k], false);
    }
    const bool all = options_.nodes.all;
    for (std::size_t band = 0; band < models_.size(); ++band) {
      const auto stored = [&](const std::string& name, std::size_t k) {
        return reader_.info().variable(name)->values[band * angles + k];
      };
      for (const std::size_t k : spread_indices(angles, all ? angles : reference_normalization_angles)) {
        engine_.watch().stop_if_asked();
        for (std::size_t lobe = 0; lobe < 3; ++lobe) {
          const std::string name = fmt::format("normalization_{}", lobe_names[lobe]);
          record(name, k, stored(name, k),
                 models_[band].normalization(static_cast<Lobe>(lobe), table_.grid.theta_i[k]).value, true);
        }
      }
      // The variant that integrates N at every node of DHR would take minutes.
      if (table_.material.variant().normalization == Normalization::reciprocal && !all) continue;
      for (const std::size_t k : spread_indices(angles, all ? angles : reference_dhr_angles)) {
        engine_.watch().stop_if_asked();
        const auto dhr = models_[band].dhr(table_.grid.theta_i[k]).unpolarized();
        const std::array values{dhr.surface.value, dhr.bulk.value, dhr.retro.value};
        for (std::size_t lobe = 0; lobe < 3; ++lobe) {
          const std::string name = fmt::format("dhr_{}", lobe_names[lobe]);
          record(name, k, stored(name, k), values[lobe], true);
        }
        record("dhr", k, stored("dhr", k), dhr.total().value, true);
      }
    }
    const bool wide = table_.working == Precision::float64 && engine_.working() == Precision::float64;
    judge(result_.normalization, wide ? promised_normalization : promised_normalization_float32);
    judge(result_.dhr, wide ? promised_dhr : promised_dhr_float32);
  }

  void record(const std::string& name, std::size_t angle, double stored, double expected, bool reference) {
    IntegralFindings& findings = name.starts_with("dhr") ? result_.dhr : result_.normalization;
    if (reference) ++findings.compared;
    // A lobe that reflects next to nothing has no relative error worth the name.
    if (name.starts_with("dhr") && std::abs(expected) < 1e-12 && std::abs(stored) < 1e-12) return;
    const double error = relative(stored, expected);
    if (error <= findings.max_relative_error) return;
    findings.max_relative_error = error;
    findings.theta_i = table_.grid.theta_i[angle];
    findings.variable = name;
  }

  void judge(const IntegralFindings& findings, double promised) {
    if (findings.max_relative_error > promised)
      fault("{} at theta_i = {} degrees differs from the model's by {:.2e}, more than {:.0e}",
            findings.variable, shortest(findings.theta_i), findings.max_relative_error, promised);
  }

  void check_energy() {
    const auto& dhr = reader_.info().variable("dhr")->values;
    for (std::size_t k = 0; k < dhr.size(); ++k)
      if (dhr[k] > result_.largest_dhr) {
        result_.largest_dhr = dhr[k];
        result_.largest_dhr_theta_i = table_.grid.theta_i[k % table_.grid.theta_i.size()];
      }
    for (std::size_t band = 0; band < plans_.size(); ++band)
      for (auto& warning :
           energy_warnings(table_.material, table_.material.bands()[band], table_.grid.theta_i.nodes(),
                           integrals_[band].dhr, table_.polarizations))
        result_.energy_warnings.push_back(std::move(warning));
  }

  // Pairs (theta_i, theta_s) and (theta_s, theta_i) that are both nodes; the model is not reciprocal, so this
  // is a figure, no fault.
  void check_reciprocity() {
    const Grid& grid = table_.grid;
    struct Common {
      std::size_t i, s;
    };
    std::vector<Common> common;
    for (std::size_t i = 0; i < grid.theta_i.size(); ++i) {
      const auto nodes = grid.theta_s.nodes();
      const auto at = std::lower_bound(nodes.begin(), nodes.end(), grid.theta_i[i]);
      if (at != nodes.end() && *at == grid.theta_i[i])
        common.push_back({i, static_cast<std::size_t>(at - nodes.begin())});
    }
    std::vector<Common> chosen;
    for (const std::size_t k : spread_indices(common.size(), reciprocity_angles)) chosen.push_back(common[k]);
    const std::size_t columns = grid.phi_s.size();
    std::vector<std::vector<double>> rows(chosen.size() * chosen.size(), std::vector<double>(columns));
    for (std::size_t a = 0; a < chosen.size(); ++a) {
      std::vector<double> slice(grid.theta_s.size() * columns);
      reader_.read(table_.polarizations.front(), 0,
                   {{chosen[a].i, chosen[a].i + 1}, {0, 1}, {0, grid.theta_s.size()}, columns}, slice);
      for (std::size_t b = 0; b < chosen.size(); ++b)
        std::copy_n(slice.begin() + static_cast<std::ptrdiff_t>(chosen[b].s * columns), columns,
                    rows[a * chosen.size() + b].begin());
    }
    std::vector<double> defects;
    Reciprocity& found = result_.reciprocity;
    for (std::size_t a = 0; a < chosen.size(); ++a)
      for (std::size_t b = a + 1; b < chosen.size(); ++b)
        for (std::size_t k = 0; k < columns; ++k) {
          const double forth = rows[a * chosen.size() + b][k], back = rows[b * chosen.size() + a][k];
          if (!(forth > 0 && back > 0)) continue;
          defects.push_back(std::abs(std::log(forth / back)));
          if (defects.back() > found.maximum) {
            found.maximum = defects.back();
            found.theta_i = grid.theta_i[chosen[a].i];
            found.theta_s = grid.theta_i[chosen[b].i];
            found.phi = grid.phi_s[k] - grid.phi_i[0];
          }
        }
    found.pairs = defects.size();
    if (defects.empty()) return;
    found.median = median(defects);
    found.percentile_90 = percentile(defects, 90);
  }

  const Engine& engine_;
  TableReader& reader_;
  const StoredTable& table_;
  const ValidateOptions& options_;
  std::vector<Integrals> integrals_;
  std::vector<Plan> plans_;
  std::vector<reference::Model> models_;
  Validation result_;
};

}  // namespace

std::string describe(const StoredTable& table, const Node& node) {
  const auto& [i, p, s, q] = node.index;
  const Band& band = table.material.bands()[node.band];
  return fmt::format("theta_i = {}, phi_i = {}, theta_s = {}, phi_s = {} degrees{} ({})",
                     shortest(table.grid.theta_i[i]), shortest(table.grid.phi_i[p]),
                     shortest(table.grid.theta_s[s]), shortest(table.grid.phi_s[q]),
                     band.wavelength_nm ? fmt::format(", {} nm", shortest(*band.wavelength_nm)) : "",
                     brdf_name(table.polarizations[node.polarization]));
}

Validation validate(const Engine& engine, TableReader& reader, const StoredTable& table,
                    const ValidateOptions& options) {
  return Validator(engine, reader, table, options).run();
}

}  // namespace brdftab

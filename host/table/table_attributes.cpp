#include "host/table/table_attributes.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/compute/rounding.hpp"
#include "host/model/variant.hpp"

namespace brdftab {
namespace {

class Attributes {
 public:
  void text(std::string name, std::string_view value) {
    if (!value.empty()) list_.push_back({std::move(name), std::string(value)});
  }
  void number(std::string name, double value) { list_.push_back({std::move(name), value}); }
  // A number, or one for each wavelength.
  void by_band(std::string name, std::vector<double> values) {
    if (values.size() == 1)
      number(std::move(name), values[0]);
    else
      list_.push_back({std::move(name), std::move(values)});
  }
  void append(std::vector<AttributeInfo> more) {
    for (auto& attribute : more) list_.push_back(std::move(attribute));
  }
  std::vector<AttributeInfo> take() { return std::move(list_); }

 private:
  std::vector<AttributeInfo> list_;
};

}  // namespace

std::vector<AttributeInfo> material_attributes(const Material& material) {
  Attributes list;
  list.text("description", material.description());
  list.text("material_source", material.source());
  list.text("material_license", material.license());
  list.text("material", material.text());
  if (!material.has_wavelengths())
    for (const auto& row : parameter_table)
      list.number(std::string(row.name), material.bands().front().parameters.*row.member);
  for (const auto& row : variant_table())
    list.text(std::string(row.name), choice_name(row, material.variant()));
  return list.take();
}

std::vector<AttributeInfo> content_attributes(const TableContent& content) {
  Attributes list;
  list.text("Conventions", "CF-1.10");
  list.text("title", fmt::format("BRDF of {}", content.material.name()));
  list.text("source", program_version);
  list.text("references", paper_reference);
  list.text("history", content.history);
  list.append(material_attributes(content.material));
  list.text("azimuth_convention", azimuth_convention);
  list.text("grid_registration", "node");
  list.append(content.grid_choice);
  list.text("device", content.device);
  list.text("build_options", content.build_options);
  list.text("working_precision", name_of(content.working));
  list.append(rounding_attributes(content));
  return list.take();
}

std::vector<AttributeInfo> rounding_attributes(const TableContent& content) {
  if (!content.storage.keep_bits) return {};
  return {{"keep_bits", static_cast<double>(*content.storage.keep_bits)},
          {"keep_bits_relative_error", rounding_error(*content.storage.keep_bits)}};
}

std::vector<AttributeInfo> findings_attributes(const TableFindings& findings) {
  Attributes list;
  double normalization_error = 0;
  double dhr_error = 0;
  for (const auto& band : findings.integrals) {
    normalization_error = std::max(normalization_error, band.normalization.largest_error());
    dhr_error = std::max(dhr_error, band.dhr.largest_error());
  }
  list.number("normalization_relative_error", normalization_error);
  list.number("dhr_relative_error", dhr_error);
  list.text("energy", findings.energy_warnings.empty()
                          ? "DHR is at most 1 at every theta_i"
                          : fmt::format("{}", fmt::join(findings.energy_warnings, "; ")));
  list.text("accuracy", "nodes of this table compared with the scalar reference while it was made");
  list.number("accuracy_nodes", static_cast<double>(findings.accuracy.nodes));
  list.number("accuracy_max_relative_error", findings.accuracy.max_relative_error);
  list.number("accuracy_rms_relative_error", findings.accuracy.rms_relative_error);

  const auto reciprocity = [&](std::string name, auto value_of) {
    std::vector<double> values;
    for (const auto& band : findings.reciprocity) values.push_back(value_of(band));
    list.by_band(std::move(name), std::move(values));
  };
  list.text("reciprocity", reciprocity_grid);
  reciprocity("reciprocity_pairs", [](const Reciprocity& r) { return static_cast<double>(r.pairs); });
  reciprocity("reciprocity_median", [](const Reciprocity& r) { return r.median; });
  reciprocity("reciprocity_90_percent", [](const Reciprocity& r) { return r.percentile_90; });
  reciprocity("reciprocity_max", [](const Reciprocity& r) { return r.maximum; });
  reciprocity("reciprocity_max_theta_i", [](const Reciprocity& r) { return r.theta_i; });
  reciprocity("reciprocity_max_theta_s", [](const Reciprocity& r) { return r.theta_s; });
  reciprocity("reciprocity_max_phi", [](const Reciprocity& r) { return r.phi; });
  return list.take();
}

std::vector<IntegralVariable> integral_variables(const std::vector<Integrals>& bands) {
  std::vector<IntegralVariable> list;
  const auto add = [&](std::string name, std::string long_name, auto value_at) {
    std::vector<double> values;
    for (const auto& band : bands)
      for (std::size_t k = 0; k < band.normalization.value[0].size(); ++k)
        values.push_back(value_at(band, k));
    list.push_back({std::move(name), std::move(long_name), std::move(values)});
  };
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    add(fmt::format("normalization_{}", lobe_names[lobe]),
        fmt::format("N of the {} lobe: 1 / integral of the bare lobe over direction cosines",
                    lobe_names[lobe]),
        [&](const Integrals& band, std::size_t k) { return band.normalization.value[lobe][k]; });
  add("dhr", "directional-hemispherical reflectance, unpolarised light",
      [](const Integrals& band, std::size_t k) { return band.dhr.total(k, Polarization::unpolarized); });
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    add(fmt::format("dhr_{}", lobe_names[lobe]),
        fmt::format("directional-hemispherical reflectance of the {} lobe, unpolarised light",
                    lobe_names[lobe]),
        [&](const Integrals& band, std::size_t k) {
          return band.dhr.lobe(lobe, k, Polarization::unpolarized);
        });
  return list;
}

std::string brdf_long_name(Polarization polarization) {
  return polarization == Polarization::unpolarized
             ? "bidirectional reflectance distribution function, unpolarised light"
             : fmt::format("bidirectional reflectance distribution function, {}-polarised light",
                           polarization_names[static_cast<std::size_t>(polarization)]);
}

}  // namespace brdftab

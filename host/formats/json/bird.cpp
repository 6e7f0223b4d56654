// The universal BRDF data format of EURAMET's project BiRD (16NRM08), in JSON, holds a list of samples, and
// the model's parameters with their uncertainty.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "host/base/numbers.hpp"
#include "host/formats/export/grid_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/json/json_file.hpp"
#include "host/formats/registry.hpp"
#include "host/model/surface_vector.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

using nlohmann::ordered_json;

constexpr std::string_view schema =
    "https://raw.githubusercontent.com/BiRD-project/BiRD_view/master/BRDF_JSON_schema/"
    "brdf_json_schema_v1.0.json";
constexpr std::string_view not_stated = "not stated";
constexpr std::string_view angles_text =
    "Angles are those of vectors that point away from the surface: the mirror direction is theta_r = "
    "theta_i, phi_r = phi_i + 180 degrees.";

// Turns azimuths as the format has them: they go from 0 to below 360 degrees, each direction once.
std::vector<double> turned(std::span<const double> azimuths, double by) {
  std::vector<double> result;
  for (const double azimuth : azimuths) {
    const double whole = azimuth + by - 360 * std::floor((azimuth + by) / 360);
    result.push_back(whole < 360 ? whole : 0);
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

void add_uncertainty(ordered_json& entry, const ParameterRow& row, const FittedParameter& fitted,
                     double level) {
  if (!fitted.interval) return;
  if (fitted.is_closed()) {
    entry["uncertainty"] = (fitted.interval->high - fitted.interval->low) / 2;
    entry["uncertainty_unit"] = row.unit;
  }
  entry["comments"] = fmt::format(
      "{}{}", fitted.is_closed() ? fmt::format("uncertainty: half the {:.4g} % interval; ", 100 * level) : "",
      text_of(fitted, level));
}

// Says how the fit as a whole stands; empty where the material does not say.
std::string fit_statistics(const Material& material) {
  const auto& fit = material.fit();
  if (!fit || !fit->condition) return {};
  return fmt::format("condition number of J^T J {:.2g}{}", *fit->condition,
                     fit->intervals == "profile"  ? "; intervals by profile likelihood"
                     : fit->intervals == "linear" ? "; intervals by standard errors"
                                                  : "");
}

// The list has one entry for each parameter, or for each band where bands differ in it.
ordered_json parameters(const Material& material) {
  std::vector<FittedParameters> fitted(material.bands().size());
  for (std::size_t b = 0; material.fit() && b < fitted.size(); ++b) fitted[b] = material.fit()->at_band(b);
  ordered_json list = ordered_json::array();
  for (std::size_t p = 0; p < parameter_table.size(); ++p) {
    const ParameterRow& row = parameter_table[p];
    const auto& bands = material.bands();
    const bool differs = std::any_of(bands.begin(), bands.end(), [&](const Band& band) {
      return band.parameters.*row.member != bands.front().parameters.*row.member;
    });
    for (std::size_t b = 0; b < (differs ? bands.size() : 1); ++b) {
      ordered_json entry{
          {"name", differs ? fmt::format("{}[{}]", row.name, shortest(*bands[b].wavelength_nm)) : row.name},
          {"symbol", row.symbol},
          {"description", row.meaning},
          {"value", bands[b].parameters.*row.member},
          {"unit", row.unit}};
      if (fitted[b][p]) add_uncertainty(entry, row, *fitted[b][p], material.fit()->level.value_or(0.95));
      list.push_back(std::move(entry));
    }
  }
  return list;
}

class BirdFormat : public ExportFormat {
 public:
  BirdFormat()
      : ExportFormat({.name = "bird",
                      .consumer = "BiRDview, and who exchanges measurements in EURAMET's BiRD format",
                      .extensions = {},
                      .suffix = "_bird.json",
                      .takes_axes = true,
                      .holds_polarization = true}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "bird_polarization",
             .help = "Of the incident light: unpolarized (default), or all: unpolarized, s and p",
             .value = &polarization_,
             .words = {"unpolarized", "all"}},
            {.name = "bird_organization",
             .help = "Whose the data are; the format requires one",
             .value = &organization_},
            {.name = "bird_contact", .help = "A person; the format requires one", .value = &contact_},
            {.name = "bird_email", .help = "The format requires one", .value = &email_}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    const Grid& grid = source.grid();
    const auto phi_i = turned(grid.phi_i.nodes(), incident_azimuth(0)), phi_r = turned(grid.phi_s.nodes(), 0);
    std::map<std::string_view, std::vector<double>> columns;
    Directions directions;
    for (const double i : grid.theta_i.nodes())
      for (const double azimuth_i : phi_i)
        for (const double r : grid.theta_s.nodes())
          for (const double azimuth_r : phi_r) {
            columns["theta_i"].push_back(i);
            columns["phi_i"].push_back(azimuth_i);
            columns["theta_r"].push_back(r);
            columns["phi_r"].push_back(azimuth_r);
            directions.add(i, r, model_phi(azimuth_i, azimuth_r));
          }
    const auto states = polarizations();
    const std::size_t blocks = states.size() * source.bands();
    check_json_samples(traits().name, blocks * directions.size());

    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{{\n\"metadata\": {},\n\"data\": {{\n", json_text(metadata(source)));
    for (const auto name : {"theta_i", "phi_i", "theta_r", "phi_r"}) {
      fmt::format_to(out, "\"{}\": {{\"unit\": \"deg\", \"values\": [", name);
      for (std::size_t block = 0; block < blocks; ++block)
        fmt::format_to(out, "{}\n{}", block ? "," : "", fmt::join(columns[name], ","));
      fmt::format_to(out, "]}},\n");
    }
    const auto repeated = [&](const std::vector<std::string>& values) {
      for (std::size_t k = 0; k < values.size() * directions.size(); ++k)
        fmt::format_to(out, "{}{}", k ? "," : "", values[k / directions.size()]);
    };
    std::vector<std::string> wavelengths, letters;
    for (const Polarization state : states)
      for (std::size_t band = 0; band < source.bands(); ++band) {
        if (source.material().has_wavelengths())
          wavelengths.push_back(shortest(source.wavelengths_nm()[band]));
        letters.emplace_back(state == Polarization::s   ? "\"s\""
                             : state == Polarization::p ? "\"p\""
                                                        : "\"u\"");
      }
    if (!wavelengths.empty()) {
      fmt::format_to(out, "\"wavelength_i\": {{\"unit\": \"nm\", \"values\": [");
      repeated(wavelengths);
      fmt::format_to(out, "]}},\n");
    }
    fmt::format_to(out, "\"polarization_i\": {{\"notation\": \"sp\", \"values\": [");
    repeated(letters);
    fmt::format_to(out, "]}},\n\"BRDF\": {{\"unit\": \"sr^-1\", \"values\": [");
    const char* comma = "";
    for (const Polarization state : states)
      for (const auto& f : source.evaluate(directions, state)) {
        fmt::format_to(out, "{}\n{:.9g}", comma, fmt::join(f, ","));
        comma = ",";
      }
    fmt::format_to(out, "]}}\n}}\n}}\n");
    write_whole(file, {text.data(), text.size()});
    return {};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.starts_with('{') && beginning.find("brdf_json_schema") != beginning.npos;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    return read_json(file, [&](const nlohmann::json& json) -> std::unique_ptr<ExportReader> {
      const auto& data = json.at("data");
      const auto values = [&](const char* name) {
        return data.at(name).at("values").get<std::vector<double>>();
      };
      const std::vector<std::vector<double>> columns{values("theta_i"), values("phi_i"), values("theta_r"),
                                                     values("phi_r"), values("BRDF")};
      const auto nm =
          data.contains("wavelength_i") ? values("wavelength_i") : std::vector<double>(columns[0].size());
      const auto states = data.contains("polarization_i")
                              ? data.at("polarization_i").at("values").get<std::vector<std::string>>()
                              : std::vector<std::string>(columns[0].size(), "u");
      for (const std::size_t size : {columns[1].size(), columns[2].size(), columns[3].size(),
                                     columns[4].size(), nm.size(), states.size()})
        if (size != columns[0].size())
          throw BadInput("{}: data have arrays of {} and of {} values", file.string(), columns[0].size(),
                         size);
      using Columns = std::vector<std::vector<double>>;
      std::map<std::string, std::map<double, Columns>> blocks;  // by polarisation, by wavelength
      for (std::size_t k = 0; k < states.size(); ++k) {
        auto& block = blocks[states[k]].try_emplace(nm[k], columns.size()).first->second;
        for (std::size_t c = 0; c < columns.size(); ++c)
          block[c].push_back(columns[c][k] - (c == 1 ? incident_azimuth(0) : 0));
      }
      if (!blocks.contains("u")) throw BadInput("{}: has no samples for unpolarised light", file.string());
      const auto samples = [&](const std::string& state) {
        std::vector<GridSamples> bands;
        for (const auto& [wavelength, block] : blocks[state])
          bands.push_back(GridSamples::from_rows(block, file.string()));
        return bands;
      };
      std::vector<double> wavelengths;
      for (const auto& [wavelength, block] : blocks["u"])
        if (wavelength > 0) wavelengths.push_back(wavelength);
      const auto section = json.at("metadata").value("adhoc_section", nlohmann::json::object());
      auto table =
          std::make_unique<GridReader>(samples("u"), std::move(wavelengths), section.value("material", ""),
                                       "linear interpolation between samples");
      for (const auto& [state, polarization] :
           {std::pair{"s", Polarization::s}, std::pair{"p", Polarization::p}})
        if (blocks.contains(state)) table->add_polarization(polarization, samples(state));
      return table;
    });
  }

 private:
  std::vector<Polarization> polarizations() const {
    if (polarization_ == "all") return {Polarization::unpolarized, Polarization::s, Polarization::p};
    return {Polarization::unpolarized};
  }

  ordered_json metadata(const ExportModel& source) const {
    const Material& material = source.material();
    ordered_json location;
    for (const auto name : {"country", "city", "street", "building_nr", "postal_code"})
      location[name] = not_stated;
    ordered_json model{{"name", "Renhorn-Boreman"},
                       {"description", paper_reference},
                       {"equation", "Eqs. (9) to (18) of the paper; variants are named in the material file"},
                       {"parameters", parameters(material)}};
    if (const std::string statistics = fit_statistics(material); !statistics.empty())
      model["comments"] = statistics;
    ordered_json json{{"schema", schema},
                      {"id", "urn:uuid:" + uuid_of(material.text())},
                      {"type", "BRDF"},
                      {"timestamp", timestamp(source)},
                      {"provenance",
                       {{"organization", organization_},
                        {"location", location},
                        {"email", email_},
                        {"contact_person", contact_}}}};
    if (!material.license().empty())
      json["license"] = {{"type", material.license()}, {"rights_holder", not_stated}};
    json["description"] = material.description().empty() ? material.name() : material.description();
    json["method"] = "simulation";
    json["instrumentation"] = "NA";
    json["software"] = {{"name", "brdftab"}, {"version", BRDFTAB_VERSION}, {"simulation_model", model}};
    json["sample"] = {{"name", material.name()},
                      {"type", "isotropic opaque surface"},
                      {"shape", "plane"},
                      {"dimensions", ordered_json::object()},
                      {"zero_azimuth_location", "any: the surface is isotropic"}};
    json["environment"] = "NA";
    json["comments"] = angles_text;
    json["adhoc_section"] = {
        {"material", material.text()}, {"material_source", material.source()}, {"history", source.history()}};
    return json;
  }

  std::string polarization_ = "unpolarized";
  std::string organization_{not_stated};
  std::string contact_{not_stated};
  std::string email_ = "not.stated@example.invalid";
};

}  // namespace

std::unique_ptr<Format> make_bird_format() { return std::make_unique<BirdFormat>(); }

}  // namespace brdftab

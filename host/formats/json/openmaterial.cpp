// Look-up tables of ASAM OpenMATERIAL 3D, in JSON, hold isotropic f of bands, in metres and radians.
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

#include "host/base/angle.hpp"
#include "host/formats/export/grid_reader.hpp"
#include "host/formats/export/grid_samples.hpp"
#include "host/formats/json/json_file.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

constexpr double nanometres = 1e9;
constexpr std::string_view version = "1.0.0";
constexpr std::string_view schema =
    "https://raw.githubusercontent.com/asam-ev/OpenMATERIAL-3D/refs/tags/v1.0.0/schemas/"
    "material_brdf_schema.json";

// Rounded so, a quarter and a whole turn are the largest values that the schema allows.
double micro_radians(double angle) { return std::round(angle / degrees_per_radian * 1e6) / 1e6; }

class OpenMaterialFormat : public ExportFormat {
 public:
  OpenMaterialFormat()
      : ExportFormat({.name = "openmaterial",
                      .consumer = "simulators of sensors that read ASAM OpenMATERIAL 3D",
                      .extensions = {".xompt"},
                      .suffix = "_brdf.xompt",
                      .takes_axes = true}) {}

  std::vector<FormatOption> options() override {
    return {{.name = "openmaterial_wavelength",
             .help = "Of a material without bands, nm; by default the table has null there",
             .value = &wavelength_nm_,
             .range = {{1, 17.16e6}}},
            {.name = "openmaterial_author",
             .help = "Name, e-mail or company; the format requires one",
             .value = &author_},
            {.name = "openmaterial_copyright",
             .help = "Year and holder; the format requires one",
             .value = &copyright_}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    std::vector<double> theta_i, theta_s, phi;
    for (const double theta : source.grid().theta_i.nodes()) theta_i.push_back(micro_radians(theta));
    for (const double theta : source.grid().theta_s.nodes()) theta_s.push_back(micro_radians(theta));
    for (const double azimuth : azimuths_away_from_surface(source.grid()))
      phi.push_back(micro_radians(azimuth));
    check_json_samples(traits().name, source.bands() * theta_i.size() * theta_s.size() * phi.size());
    Directions directions;
    for (const double i : theta_i)
      for (const double s : theta_s)
        for (const double azimuth : phi) directions.add(degrees(i), degrees(s), degrees(azimuth) - 180);
    const auto f = source.evaluate(directions);
    std::vector<std::string> wavelengths;
    for (const double nm : wavelengths_of(source)) wavelengths.push_back(fmt::format("{}", nm / nanometres));

    fmt::memory_buffer text;
    const auto out = std::back_inserter(text);
    fmt::format_to(out, "{{\n\"$schema\": \"{}\",\n\"metadata\": {},\n", schema, json_text(metadata(source)));
    fmt::format_to(out, "\"brdf\": {{\n\"wavelengths\": [{}],\n\"lookupTable\": [",
                   fmt::join(wavelengths, ", "));
    for (std::size_t band = 0; band < f.size(); ++band) {
      const std::string wavelength = wavelengths.empty() ? "null" : wavelengths[band];
      std::size_t k = 0;
      for (const double i : theta_i)
        for (const double s : theta_s)
          for (const double azimuth : phi) {
            fmt::format_to(out, "{}\n[{}, {}, {}, {}, {:.9g}]", band + k ? "," : "", wavelength, i, s,
                           azimuth, f[band][k]);
            ++k;
          }
    }
    fmt::format_to(out, "\n]\n}},\n\"generator\": {}\n}}\n",
                   json_text({{"source", program_version},
                              {"references", paper_reference},
                              {"history", source.history()},
                              {"material", source.material().text()}}));
    write_whole(file, {text.data(), text.size()});
    if (!wavelengths.empty()) return {};
    return {
        "the material has no wavelength, and the table null in its place: `openmaterial_wavelength` gives "
        "one"};
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.find("material_brdf_schema") != beginning.npos ||
           beginning.find("\"openMaterial3dVersion\"") != beginning.npos;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    return read_json(file, [&](const nlohmann::json& json) -> std::unique_ptr<ExportReader> {
      using Columns = std::vector<std::vector<double>>;
      std::map<double, Columns> rows;  // by wavelength
      for (const auto& row : json.at("brdf").at("lookupTable")) {
        const double wavelength = row.at(0).is_null() ? 0 : row.at(0).get<double>();
        Columns& columns = rows.try_emplace(wavelength, Columns(5)).first->second;
        columns[0].push_back(degrees(row.at(1).get<double>()));
        columns[1].push_back(0);
        columns[2].push_back(degrees(row.at(2).get<double>()));
        columns[3].push_back(degrees(row.at(3).get<double>()) - 180);
        columns[4].push_back(row.at(4).get<double>());
      }
      if (rows.empty()) throw BadInput("{}: lookupTable has no rows", file.string());
      std::vector<GridSamples> bands;
      std::vector<double> wavelengths;
      for (const auto& [wavelength, columns] : rows) {
        bands.push_back(GridSamples::from_rows(columns, file.string()));
        // Metres are written to the last digit, but nanometres are what a material has.
        if (wavelength > 0) wavelengths.push_back(std::round(wavelength * nanometres * 1e6) / 1e6);
      }
      const auto generator = json.value("generator", nlohmann::json::object());
      return std::make_unique<GridReader>(std::move(bands), std::move(wavelengths),
                                          generator.value("material", ""));
    });
  }

 private:
  std::vector<double> wavelengths_of(const ExportModel& source) const {
    std::vector<double> wavelengths = source.wavelengths_nm();
    if (wavelengths.empty() && wavelength_nm_) wavelengths.push_back(*wavelength_nm_);
    return wavelengths;
  }

  nlohmann::ordered_json metadata(const ExportModel& source) const {
    const Material& material = source.material();
    std::string date;
    for (const char c : timestamp(source))
      if (c != '-' && c != ':') date += c;
    const std::string origin =
        material.source().empty() ? "" : fmt::format("; parameters from: {}", material.source());
    return {{"name", material.name()},
            {"description",
             fmt::format("{}{}f in 1/sr, unpolarised. Angles are of vectors that point away from the "
                         "surface: the mirror direction has an exit azimuth of pi, retro-reflection of 0.",
                         material.description(), material.description().empty() ? "" : ". ")},
            {"uuid", uuid_of(material.text())},
            {"materialVersion", "1.0.0"},
            {"openMaterial3dVersion", version},
            {"copyrights", nlohmann::ordered_json::array({copyright_})},
            {"license", material.license().empty() ? "not stated" : material.license()},
            {"authors", nlohmann::ordered_json::array({author_})},
            {"creationDate", date},
            {"sources", fmt::format("simulation by {}: {}{}", program_version, paper_reference, origin)}};
  }

  std::optional<double> wavelength_nm_;
  std::string author_ = "not stated";
  std::string copyright_ = "not stated";
};

}  // namespace

std::unique_ptr<Format> make_openmaterial_format() { return std::make_unique<OpenMaterialFormat>(); }

}  // namespace brdftab

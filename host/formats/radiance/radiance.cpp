// Radiance's BSDF files in XML hold a matrix over Klems patches or a tensor tree of rank 3.
#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <sstream>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/base/xml_text.hpp"
#include "host/formats/export/export_text.hpp"
#include "host/formats/radiance/klems_basis.hpp"
#include "host/formats/radiance/radiance_reader.hpp"
#include "host/formats/radiance/tensor_tree.hpp"
#include "host/formats/radiance/xml_file.hpp"
#include "host/formats/registry.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

constexpr std::string_view klems_name = "LBNL/Klems Full", tree_name = "TensorTree3";

using Channels = std::vector<std::vector<double>>;

std::string angle_basis() {
  std::string text = fmt::format("<AngleBasis>\n<AngleBasisName>{}</AngleBasisName>\n", klems_name);
  for (const KlemsBand& band : klems_bands)
    text += fmt::format(
        "<AngleBasisBlock><Theta>{}</Theta><nPhis>{}</nPhis><ThetaBounds><LowerTheta>{}</"
        "LowerTheta><UpperTheta>{}</UpperTheta></ThetaBounds></AngleBasisBlock>\n",
        band.centre, band.patches, band.first, band.last);
  return text + "</AngleBasis>\n";
}

std::string matrix_text(const std::vector<double>& matrix) {
  fmt::memory_buffer text;
  for (std::size_t k = 0; k < matrix.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{:.7g}{}", matrix[k], (k + 1) % klems_patches ? ' ' : '\n');
  return fmt::to_string(text);
}

std::vector<double> numbers(const std::string& text, const XmlElement& data) {
  std::vector<double> values;
  std::string_view rest = text;
  while (!(rest = trimmed(rest)).empty()) {
    const auto end = std::min(rest.find_first_of(" \t\r\n,"), rest.size());
    const auto value = parse_number(rest.substr(0, end));
    if (!value) data.refuse("ScatteringData", fmt::format("{}: not a number", excerpt(rest.substr(0, end))));
    values.push_back(std::max(*value, 0.));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return values;
}

std::vector<double> read_matrix(const XmlElement& data) {
  for (const auto name : {"ColumnAngleBasis", "RowAngleBasis"})
    if (const std::string basis = data.text(name); basis != klems_name)
      data.refuse(name, fmt::format("{}; only {} is read", basis, klems_name));
  std::vector<double> matrix = numbers(data.text("ScatteringData"), data);
  if (matrix.size() != klems_patches * klems_patches)
    data.refuse("ScatteringData",
                fmt::format("{} values; {} are needed", matrix.size(), klems_patches * klems_patches));
  return matrix;
}

// Gives the matrices in the order of `radiance_wavelengths`, however the file has them.
Channels read_matrices(const XmlElement& xml) {
  Channels matrices(radiance_wavelengths.size());
  for (const XmlElement& data : xml.elements("WavelengthData")) {
    const auto wavelength =
        std::find(radiance_wavelengths.begin(), radiance_wavelengths.end(), data.text("Wavelength"));
    if (wavelength == radiance_wavelengths.end()) continue;
    auto& matrix = matrices[static_cast<std::size_t>(wavelength - radiance_wavelengths.begin())];
    if (!matrix.empty()) data.refuse("Wavelength", fmt::format("{} is there twice", *wavelength));
    matrix = read_matrix(data);
  }
  std::erase_if(matrices, [](const auto& matrix) { return matrix.empty(); });
  if (matrices.size() != 1 && matrices.size() != 3)
    xml.refuse("WavelengthData",
               fmt::format("{} channels of luminance and colour; there must be 1 or 3", matrices.size()));
  return matrices;
}

TensorTree read_tree(const XmlElement& xml) {
  const auto all = xml.elements("WavelengthData");
  if (all.empty()) xml.refuse("WavelengthData", "is missing");
  const XmlElement& data = all.front();
  if (const std::string wavelength = data.text("Wavelength"); wavelength != radiance_wavelengths.front())
    data.refuse("Wavelength", fmt::format("{}; trees are read of luminance alone", wavelength));
  const std::string text = data.text("ScatteringData");
  try {
    return TensorTree::parsed(text);
  } catch (const BadInput& fault) {
    data.refuse("ScatteringData", fault.what());
  }
}

class RadianceFormat : public ExportFormat {
 public:
  RadianceFormat()
      : ExportFormat({.name = "radiance",
                      .consumer = "Radiance (BSDF, aBSDF), and what reads its XML",
                      .extensions = {".xml"},
                      .suffix = ".xml"}) {}

  std::vector<FormatOption> options() override {
    return {
        {.name = "radiance_basis",
         .help = "tree: tensor tree of rank 3, cells cut where f varies (default for one band); klems: "
                 "matrix of 145 x 145 Klems patches (default for several, as colours)",
         .value = &basis_,
         .words = {"tree", "klems"}},
        {.name = "radiance_values",
         .help = "average (default): the mean of f over each cell or pair of patches, which keeps its "
                 "integrals; centre: f at its centre",
         .value = &values_,
         .words = {"average", "centre"}},
        {.name = "radiance_depth",
         .help = "Tree: at most 2^N cells across, N of 3 to 9; default 8",
         .value = &depth_,
         .range = {{3, 9}}},
        {.name = "radiance_tolerance",
         .help = "Tree: a cell is cut in eight where f varies over it by more than this share; default 0.1",
         .value = &tolerance_,
         .range = {{1e-4, 10}}}};
  }

  std::vector<std::string> write(const std::filesystem::path& file,
                                 const ExportModel& source) const override {
    std::vector<std::string> notes;
    std::string definition;
    std::vector<std::string> data;
    const bool klems = basis_ == "klems" || (basis_.empty() && source.bands() > 1);
    if (!klems && source.bands() > 1)
      throw BadInput(
          "`radiance_basis` tree: Radiance mixes up the colours of a tensor tree of rank 3; klems holds "
          "them, and `wavelength` takes one band");
    if (klems) {
      definition = fmt::format("<IncidentDataStructure>Columns</IncidentDataStructure>\n{}", angle_basis());
      const auto value = values_ == "average" ? PatchValue::average : PatchValue::centre;
      for (const auto& matrix : radiance_colours(source, klems_matrix(source, value)))
        data.push_back(matrix_text(matrix));
    } else {
      definition = fmt::format("<IncidentDataStructure>{}</IncidentDataStructure>\n", tree_name);
      const TensorTree tree = grown(source);
      data.push_back(tree.text() + '\n');
      notes.push_back(fmt::format("a tensor tree of {} cells", tree.leaves()));
    }
    const bool colour = data.size() == 3;
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<WindowElement xmlns=\"http://windows.lbl.gov\" "
        "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" "
        "xsi:schemaLocation=\"http://windows.lbl.gov/BSDF-v1.4.xsd\">\n<!--\n";
    for (const auto& line : description_lines(source, colour ? ExportChannels::xyz : ExportChannels::bands))
      text += xml_comment(line) + '\n';
    text += fmt::format(
        "-->\n<WindowElementType>System</WindowElementType>\n<FileType>BSDF</"
        "FileType>\n<Optical>\n<Layer>\n<Material>\n"
        "<Name>{}</Name>\n<Manufacturer>{}</Manufacturer>\n<DeviceType>Other</DeviceType>\n</"
        "Material>\n<DataDefinition>\n"
        "{}</DataDefinition>\n",
        xml_escaped(source.material().name()), xml_escaped(program_version), definition);
    for (std::size_t channel = 0; channel < data.size(); ++channel)
      text += wavelength_data(source, klems, channel, data);
    text += "</Layer>\n</Optical>\n</WindowElement>\n";
    write_whole(file, text);
    return notes;
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    // UTF-16 has a zero beside each letter.
    std::string text(beginning);
    std::erase(text, '\0');
    return text.find("<?xml") != text.npos && text.find("WindowElement") != text.npos;
  }

  std::unique_ptr<ExportReader> read(const std::filesystem::path& file) const override {
    const XmlFile xml(file);
    Description description;
    for (const std::string& comment : xml.comments()) {
      std::istringstream lines(comment);
      for (std::string line; std::getline(lines, line);) description.read(xml_comment_line(line));
    }
    const XmlElement root = xml.root();
    const std::string structure = root.text("IncidentDataStructure");
    if (structure == "Columns") return klems_reader(std::move(description), read_matrices(root));
    if (structure == tree_name) return tree_reader(std::move(description), read_tree(root));
    root.refuse("IncidentDataStructure", fmt::format("{}; Columns and {} are read", structure, tree_name));
  }

 private:
  TensorTree grown(const ExportModel& source) const {
    // Darkness is judged by the f of a diffuse surface with the same reflectance.
    const std::array<double, 1> near_normal{30.};
    double reflectance = 0;
    for (const auto& band : source.dhr(near_normal)) reflectance = std::max(reflectance, band.front());
    constexpr double share_of_mean = 0.01;
    return TensorTree::refined(
        [&](const std::vector<TreePoint>& points) {
          Directions directions;
          for (const TreePoint& point : points) add(directions, point);
          return source.evaluate(directions).front();
        },
        {.depth = depth_,
         .tolerance = tolerance_,
         .floor = share_of_mean * reflectance / std::numbers::pi,
         .average = values_ == "average"});
  }

  static std::string wavelength_data(const ExportModel& source, bool klems, std::size_t channel,
                                     const std::vector<std::string>& data) {
    const bool colour = data.size() == 3;
    const std::string basis =
        klems ? fmt::format("<ColumnAngleBasis>{0}</ColumnAngleBasis>\n<RowAngleBasis>{0}</RowAngleBasis>\n",
                            klems_name)
              : "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>\n";
    // The side that the normal points to is the back of WINDOW's windows.
    return fmt::format(
        "<WavelengthData>\n<LayerNumber>System</LayerNumber>\n<Wavelength unit=\"Integral\">{}</Wavelength>\n"
        "<SourceSpectrum>{}</SourceSpectrum>\n<DetectorSpectrum>{}</"
        "DetectorSpectrum>\n<WavelengthDataBlock>\n"
        "<WavelengthDataDirection>Reflection "
        "Back</WavelengthDataDirection>\n{}<ScatteringDataType>BRDF</ScatteringDataType>\n"
        "<ScatteringData>\n{}</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n",
        radiance_wavelengths[channel],
        colour ? fmt::format("CIE Illuminant {}", name_of(source.illuminant())) : "None",
        colour ? "CIE 1931 2 degree" : "None", basis, data[channel]);
  }

  std::string basis_;
  std::string values_ = "average";
  int depth_ = 8;
  double tolerance_ = 0.1;
};

}  // namespace

std::unique_ptr<Format> make_radiance_format() { return std::make_unique<RadianceFormat>(); }

}  // namespace brdftab

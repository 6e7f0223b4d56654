// BSDF of Radiance in XML, as a matrix over Klems patches or as a tensor tree of rank 3.
#include <algorithm>
#include <iterator>
#include <numbers>

#include "host/error.hpp"
#include "host/export_text.hpp"
#include "host/formats/formats.hpp"
#include "host/formats/klems_basis.hpp"
#include "host/formats/tensor_tree.hpp"
#include "host/formats/xml_text.hpp"
#include "host/numbers.hpp"
#include "host/table_content.hpp"
#include "host/whole_file.hpp"

namespace brdftab {
namespace {

constexpr std::string_view klems_name = "LBNL/Klems Full", tree_name = "TensorTree3";
// The components of colour that Radiance looks for, beside that of luminance, which comes first.
constexpr std::array<std::string_view, 3> matrix_channels{"Visible", "CIE-X", "CIE-Z"};
constexpr std::array<std::string_view, 3> tree_channels{"Visible", "CIE-u", "CIE-v"};

using Channels = std::vector<std::vector<double>>;

// Luminance alone, or with X and Z.
Channels matrix_colours(const ExportSource& source, const Channels& by_band) {
  if (by_band.size() == 1) return by_band;
  auto xyz = source.xyz(by_band);
  std::swap(xyz[0], xyz[1]);
  return xyz;
}

// Luminance alone, or with the coordinates u' and v' of CIE 1976.
Channels tree_colours(const ExportSource& source, const Channels& by_band) {
  auto channels = matrix_colours(source, by_band);
  if (channels.size() == 1) return channels;
  for (std::size_t k = 0; k < channels[0].size(); ++k) {
    const double y = channels[0][k], x = channels[1][k], z = channels[2][k], sum = x + 15 * y + 3 * z;
    channels[1][k] = sum > 0 ? 4 * x / sum : 4. / 19;
    channels[2][k] = sum > 0 ? 9 * y / sum : 9. / 19;
  }
  return channels;
}

class RadianceTable : public ExportedTable {
 public:
  explicit RadianceTable(Description description, std::size_t channels)
      : description_(std::move(description)), colour_(channels == 3) {}

  ExportChannels channels() const override { return colour_ ? ExportChannels::xyz : ExportChannels::bands; }
  Illuminant illuminant() const override { return description_.illuminant; }
  std::vector<double> wavelengths_nm() const override { return description_.wavelengths_nm; }
  std::string material_text() const override { return description_.material_text; }

 private:
  Description description_;
  bool colour_;
};

class KlemsTable : public RadianceTable {
 public:
  KlemsTable(Description description, Channels matrices)
      : RadianceTable(std::move(description), matrices.size()), matrices_(std::move(matrices)) {}

  Channels evaluate(const Directions& directions) const override {
    Channels f;
    for (const auto& matrix : matrices_) {
      auto& values = f.emplace_back();
      for (std::size_t k = 0; k < directions.size(); ++k)
        values.push_back(matrix[klems_patch(directions.theta_s[k], directions.phi[k]) * klems_patches +
                                klems_patch(directions.theta_i[k], 0)]);
    }
    if (f.size() == 3) std::swap(f[0], f[1]);
    return f;
  }
  std::string interpolation() const override { return "the nearest pair of Klems patches"; }

 private:
  Channels matrices_;
};

class TreeTable : public RadianceTable {
 public:
  TreeTable(Description description, std::vector<TensorTree> trees)
      : RadianceTable(std::move(description), trees.size()), trees_(std::move(trees)) {}

  Channels evaluate(const Directions& directions) const override {
    Channels f(trees_.size());
    for (std::size_t k = 0; k < directions.size(); ++k) {
      const TreePoint point = tree_point(directions, k);
      const double y = trees_[0].at(0, point);
      if (f.size() == 1) {
        f[0].push_back(y);
        continue;
      }
      const double u = trees_[1].at(0, point), v = trees_[2].at(0, point);
      f[0].push_back(v > 0 ? y * 9 * u / (4 * v) : 0);
      f[1].push_back(y);
      f[2].push_back(v > 0 ? y * (12 - 3 * u - 20 * v) / (4 * v) : 0);
    }
    return f;
  }
  std::string interpolation() const override { return "the nearest cell of the tree"; }

 private:
  std::vector<TensorTree> trees_;
};

std::string angle_basis() {
  std::string text = fmt::format("<AngleBasis>\n<AngleBasisName>{}</AngleBasisName>\n", klems_name);
  for (const KlemsBand& band : klems_bands)
    text += fmt::format(
        "<AngleBasisBlock><Theta>{}</Theta><nPhis>{}</nPhis><ThetaBounds><LowerTheta>{}</LowerTheta><UpperTheta>{}</UpperTheta>"
        "</ThetaBounds></AngleBasisBlock>\n",
        band.centre, band.patches, band.first, band.last);
  return text + "</AngleBasis>\n";
}

std::string matrix_text(const std::vector<double>& matrix) {
  fmt::memory_buffer text;
  for (std::size_t k = 0; k < matrix.size(); ++k)
    fmt::format_to(std::back_inserter(text), "{:.7g}{}", matrix[k], (k + 1) % klems_patches ? ' ' : '\n');
  return fmt::to_string(text);
}

Channels read_matrices(const XmlText& xml) {
  Channels matrices;
  for (const XmlText& data : xml.elements("WavelengthData")) {
    const auto wavelength = data.text("Wavelength");
    if (std::find(matrix_channels.begin(), matrix_channels.end(), wavelength) == matrix_channels.end()) continue;
    for (const auto name : {"ColumnAngleBasis", "RowAngleBasis"})
      if (data.text(name) != klems_name) data.refuse(name, fmt::format("{}; only {} is read", data.text(name), klems_name));
    auto& matrix = matrices.emplace_back();
    std::string_view rest = data.text("ScatteringData");
    while (!(rest = trimmed(rest)).empty()) {
      const auto end = std::min(rest.find_first_of(" \t\r\n,"), rest.size());
      const auto value = parse_number(rest.substr(0, end));
      if (!value) data.refuse("ScatteringData", fmt::format("{}: not a number", excerpt(rest.substr(0, end))));
      matrix.push_back(std::max(*value, 0.));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    if (matrix.size() != klems_patches * klems_patches)
      data.refuse("ScatteringData", fmt::format("{} values; {} are needed", matrix.size(), klems_patches * klems_patches));
  }
  return matrices;
}

std::vector<TensorTree> read_trees(const XmlText& xml) {
  std::vector<TensorTree> trees;
  for (const XmlText& data : xml.elements("WavelengthData")) {
    const auto wavelength = data.text("Wavelength");
    if (std::find(tree_channels.begin(), tree_channels.end(), wavelength) == tree_channels.end()) continue;
    try {
      trees.push_back(TensorTree::parsed(data.text("ScatteringData")));
    } catch (const BadInput& fault) {
      data.refuse("ScatteringData", fault.what());
    }
  }
  return trees;
}

class RadianceFormat : public ExportFormat {
 public:
  RadianceFormat()
      : ExportFormat({.name = "radiance",
                      .consumer = "Radiance (BSDF, aBSDF), and what reads its XML",
                      .extensions = {".xml"},
                      .suffix = ".xml"}) {}

  void add_options(CLI::App& group) override {
    group
        .add_option("--radiance-basis", basis_,
                    "tree (default): tensor tree of rank 3, cells cut where f varies; klems: matrix of 145 x 145 Klems patches")
        ->check(CLI::IsMember({"tree", "klems"}));
    group
        .add_option("--radiance-values", values_,
                    "average (default): the mean of f over each cell or pair of patches, which keeps its integrals; centre: f at "
                    "its centre")
        ->check(CLI::IsMember({"average", "centre"}));
    group.add_option("--radiance-depth", depth_, "Tree: at most 2^N cells across, N of 3 to 9; default 8")
        ->check(CLI::Range(3, 9));
    group
        .add_option("--radiance-tolerance", tolerance_,
                    "Tree: a cell is cut in eight where f varies over it by more than this share; default 0.1")
        ->check(CLI::Range(1e-4, 10.));
  }

  std::vector<std::string> write(const std::filesystem::path& file, const ExportSource& source) const override {
    std::vector<std::string> notes;
    std::string definition;
    std::vector<std::string> data;
    if (basis_ == "klems") {
      definition = fmt::format("<IncidentDataStructure>Columns</IncidentDataStructure>\n{}", angle_basis());
      const auto value = values_ == "average" ? PatchValue::average : PatchValue::centre;
      for (const auto& matrix : matrix_colours(source, klems_matrix(source, value))) data.push_back(matrix_text(matrix));
    } else {
      definition = fmt::format("<IncidentDataStructure>{}</IncidentDataStructure>\n", tree_name);
      const TensorTree tree = grown(source);
      for (std::size_t channel = 0; channel < tree.channels(); ++channel) data.push_back(tree.text(channel) + '\n');
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
        "-->\n<WindowElementType>System</WindowElementType>\n<FileType>BSDF</FileType>\n<Optical>\n<Layer>\n<Material>\n"
        "<Name>{}</Name>\n<Manufacturer>{}</Manufacturer>\n<DeviceType>Other</DeviceType>\n</Material>\n<DataDefinition>\n"
        "{}</DataDefinition>\n",
        xml_escaped(source.material().name()), xml_escaped(program_source), definition);
    for (std::size_t channel = 0; channel < data.size(); ++channel)
      text += wavelength_data(source, channel, colour, data[channel]);
    text += "</Layer>\n</Optical>\n</WindowElement>\n";
    write_whole(file, text);
    return notes;
  }

  bool recognises(const std::filesystem::path&, std::string_view beginning) const override {
    return beginning.find("<?xml") != beginning.npos && beginning.find("<WindowElement") != beginning.npos;
  }

  std::unique_ptr<ExportedTable> read(const std::filesystem::path& file) const override {
    const std::string text = read_whole(file);
    const XmlText xml(text, file.string());
    Description description;
    for (const std::string& line : xml.comment_lines()) description.read(line);
    const auto structure = xml.text("IncidentDataStructure");
    if (structure == "Columns")
      return std::make_unique<KlemsTable>(std::move(description), one_or_three(xml, read_matrices(xml)));
    if (structure == tree_name) return std::make_unique<TreeTable>(std::move(description), one_or_three(xml, read_trees(xml)));
    xml.refuse("IncidentDataStructure", fmt::format("{}; Columns and {} are read", structure, tree_name));
  }

 private:
  template <class Channel>
  static std::vector<Channel> one_or_three(const XmlText& xml, std::vector<Channel> channels) {
    if (channels.size() != 1 && channels.size() != 3)
      xml.refuse("WavelengthData", fmt::format("{} channels of luminance and colour; there must be 1 or 3", channels.size()));
    return channels;
  }

  TensorTree grown(const ExportSource& source) const {
    // The mean of f by which darkness is judged: of a diffuse surface with the same reflectance.
    const std::array<double, 1> near_normal{30.};
    double reflectance = 0;
    for (const auto& band : source.dhr(near_normal)) reflectance = std::max(reflectance, band.front());
    constexpr double share_of_mean = 0.01;
    return TensorTree::refined(
        [&](const std::vector<TreePoint>& points) {
          Directions directions;
          for (const TreePoint& point : points) add(directions, point);
          return tree_colours(source, source.evaluate(directions));
        },
        {.depth = depth_,
         .tolerance = tolerance_,
         .floor = share_of_mean * reflectance / std::numbers::pi,
         .average = values_ == "average"});
  }

  std::string wavelength_data(const ExportSource& source, std::size_t channel, bool colour, const std::string& data) const {
    const bool klems = basis_ == "klems";
    const std::string basis =
        klems ? fmt::format("<ColumnAngleBasis>{0}</ColumnAngleBasis>\n<RowAngleBasis>{0}</RowAngleBasis>\n", klems_name)
              : "<AngleBasis>LBNL/Shirley-Chiu</AngleBasis>\n";
    // The side that the normal points to is the back of WINDOW's windows.
    return fmt::format(
        "<WavelengthData>\n<LayerNumber>System</LayerNumber>\n<Wavelength unit=\"Integral\">{}</Wavelength>\n"
        "<SourceSpectrum>{}</SourceSpectrum>\n<DetectorSpectrum>{}</DetectorSpectrum>\n<WavelengthDataBlock>\n"
        "<WavelengthDataDirection>Reflection Back</WavelengthDataDirection>\n{}<ScatteringDataType>BRDF</ScatteringDataType>\n"
        "<ScatteringData>\n{}</ScatteringData>\n</WavelengthDataBlock>\n</WavelengthData>\n",
        (klems ? matrix_channels : tree_channels)[channel],
        colour ? fmt::format("CIE Illuminant {}", name_of(source.illuminant())) : "None", colour ? "CIE 1931 2 degree" : "None",
        basis, data);
  }

  std::string basis_ = "tree";
  std::string values_ = "average";
  int depth_ = 8;
  double tolerance_ = 0.1;
};

}  // namespace

std::unique_ptr<ExportFormat> make_radiance_format() { return std::make_unique<RadianceFormat>(); }

}  // namespace brdftab

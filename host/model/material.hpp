// A material: the fourteen parameters, for each band, the variant of the model, the grid that its file may
// give and what a fit says about itself. It cannot exist invalid: the only way to have one is to read it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/model/axis.hpp"
#include "host/model/material/fit_record.hpp"
#include "host/model/parameters.hpp"

namespace brdftab {

/// One set of parameters; the wavelength is in nm, and absent where the file has no bands.
struct Band {
  std::optional<double> wavelength_nm;
  Parameters parameters;
};

/// What a material file says.
struct MaterialContent {
  std::string name, description, source, license;
  Variant variant;
  /// At least one; wavelengths, where there are any, increase strictly.
  std::vector<Band> bands;
  Grid grid;
  /// Where a fit made the material; as many of its bands as the material has.
  std::optional<FitRecord> fit;
};

class Material {
 public:
  /// Reads a TOML file ("-": standard input). Throws FileError where it cannot be read, and BadInput with
  /// `FILE:LINE:COLUMN: KEY = VALUE: what is allowed` where its content is not a material.
  static Material read(const std::filesystem::path& file);

  /// The same from text; `source` stands for the file's name in messages.
  static Material parse(std::string text, const std::string& source);

  /// Writes the content as a file's text and reads that. Throws BadInput where it is not a material; line and
  /// column are those of the text written.
  static Material of(const MaterialContent& content);

  const std::string& name() const { return content_.name; }
  const std::string& description() const { return content_.description; }
  const std::string& source() const { return content_.source; }
  const std::string& license() const { return content_.license; }
  /// The whole file, as given.
  const std::string& text() const { return text_; }
  const Variant& variant() const { return content_.variant; }
  /// At least one; wavelengths, where there are any, increase strictly.
  const std::vector<Band>& bands() const { return content_.bands; }
  bool has_wavelengths() const { return bands().front().wavelength_nm.has_value(); }
  const Grid& grid() const { return content_.grid; }
  /// None where no fit made it.
  const std::optional<FitRecord>& fit() const { return content_.fit; }
  const MaterialContent& content() const { return content_; }

  /// The same material with one of its bands, for what holds only one; its text stays whole. Throws BadInput,
  /// which lists the bands, where none has this wavelength.
  Material at_wavelength(double wavelength_nm) const;

 private:
  Material(MaterialContent content, std::string text)
      : content_(std::move(content)), text_(std::move(text)) {}

  MaterialContent content_;
  std::string text_;
};

/// The largest material file, which a table must be able to carry whole.
inline constexpr std::size_t largest_material_bytes = 1 << 20;

}  // namespace brdftab

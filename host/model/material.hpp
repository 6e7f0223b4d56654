// A material: the fourteen parameters, for each band, the variant of the model,
// and the grid that its file may give. It cannot exist invalid: the only way to
// have one is to read it.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/model/axis.hpp"
#include "host/model/parameters.hpp"

namespace brdftab {

/// One set of parameters; the wavelength is in nm, and absent where the file has no bands.
struct Band {
  std::optional<double> wavelength_nm;
  Parameters parameters;
};

class Material {
 public:
  /// Reads a TOML file ("-": standard input). Throws FileError where it cannot be read, and BadInput with
  /// `FILE:LINE:COLUMN: KEY = VALUE: what is allowed` where its content is not a material.
  static Material read(const std::filesystem::path& file);

  /// The same from text; `source` stands for the file's name in messages.
  static Material parse(std::string text, const std::string& source);

  const std::string& name() const { return name_; }
  const std::string& description() const { return description_; }
  const std::string& source() const { return source_; }
  const std::string& license() const { return license_; }
  /// The whole file, as given.
  const std::string& text() const { return text_; }
  const Variant& variant() const { return variant_; }
  /// At least one; wavelengths, where there are any, increase strictly.
  const std::vector<Band>& bands() const { return bands_; }
  bool has_wavelengths() const { return bands_.front().wavelength_nm.has_value(); }
  const Grid& grid() const { return grid_; }

  /// The same material with one of its bands, for what holds only one; its text stays whole. Throws BadInput,
  /// which lists the bands, where none has this wavelength.
  Material at_wavelength(double wavelength_nm) const;

 private:
  Material() = default;
  friend class MaterialReader;

  std::string name_;
  std::string description_;
  std::string source_;
  std::string license_;
  std::string text_;
  Variant variant_;
  std::vector<Band> bands_;
  Grid grid_;
};

/// The largest material file, which a table must be able to carry whole.
inline constexpr std::size_t largest_material_bytes = 1 << 20;

}  // namespace brdftab

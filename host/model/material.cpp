#include "host/model/material.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"
#include "host/model/material/material_reader.hpp"
#include "host/model/material/material_toml.hpp"

namespace brdftab {

Material Material::at_wavelength(double wavelength_nm) const {
  if (!has_wavelengths())
    throw BadInput("{} has no bands, and so none at {} nm", name(), shortest(wavelength_nm));
  const auto band = std::find_if(bands().begin(), bands().end(),
                                 [&](const Band& b) { return b.wavelength_nm == wavelength_nm; });
  if (band == bands().end()) {
    std::vector<std::string> known;
    for (const Band& b : bands()) known.push_back(shortest(*b.wavelength_nm));
    throw BadInput("{} has no band at {} nm; it has {}", name(), shortest(wavelength_nm),
                   fmt::join(known, ", "));
  }
  Material result = *this;
  result.content_.bands = {*band};
  if (fit()) result.content_.fit->bands = {fit()->bands[static_cast<std::size_t>(band - bands().begin())]};
  return result;
}

Material Material::parse(std::string text, const std::string& source) {
  MaterialContent content = read_material_content(text, source);
  return {std::move(content), std::move(text)};
}

Material Material::of(const MaterialContent& content) { return parse(material_toml(content), content.name); }

Material Material::read(const std::filesystem::path& file) {
  std::string text;
  const auto take = [&](std::istream& in) {
    text.resize(largest_material_bytes + 1);
    in.read(text.data(), static_cast<std::streamsize>(text.size()));
    text.resize(static_cast<std::size_t>(in.gcount()));
  };
  if (file == "-") {
    take(std::cin);
  } else {
    std::error_code error;
    if (std::filesystem::is_directory(file, error))
      throw FileError("{}: is a folder, not a material file", file.string());
    std::ifstream in = open_file(file);
    take(in);
  }
  const std::string source = file == "-" ? "standard input" : file.string();
  if (text.size() > largest_material_bytes)
    throw BadInput("{}:1:1: is larger than {} bytes, the most that a material file may have", source,
                   largest_material_bytes);
  return parse(std::move(text), source);
}

}  // namespace brdftab

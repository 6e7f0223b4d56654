#include "host/formats/export/export_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "host/base/numbers.hpp"
#include "host/table/table_content.hpp"

namespace brdftab {
namespace {

constexpr std::string_view material_mark = "| ";
constexpr std::string_view wavelengths_mark = "wavelengths_nm:";
constexpr std::string_view illuminant_mark = "illuminant:";

}  // namespace

std::vector<std::string> description_lines(const ExportModel& source, ExportChannels channels) {
  std::vector<std::string> lines;
  lines.push_back(fmt::format("BRDF of {}: f in 1/sr, not weighted by a cosine, unpolarised",
                              excerpt(source.material().name())));
  lines.push_back(fmt::format("{}; {}", program_version, paper_reference));
  lines.push_back(source.history());
  if (channels == ExportChannels::rgb) lines.emplace_back(rgb_convention(source.illuminant()));
  if (channels == ExportChannels::xyz)
    lines.emplace_back(
        "X, Y, Z of the CIE 1931 2-degree observer, each relative to the white's; f linear between bands, "
        "constant beyond");
  if (channels != ExportChannels::bands)
    lines.push_back(fmt::format("{} {}", illuminant_mark, name_of(source.illuminant())));
  if (const auto wavelengths = source.wavelengths_nm(); !wavelengths.empty()) {
    std::string line(wavelengths_mark);
    for (const double wavelength : wavelengths) line += fmt::format(" {}", shortest(wavelength));
    lines.push_back(line);
  }
  lines.emplace_back("material file:");
  std::string_view text = source.material().text();
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    std::string_view line = text.substr(0, end);
    if (line.ends_with('\r')) line.remove_suffix(1);
    lines.push_back(fmt::format("{}{}", material_mark, line));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

void Description::read(std::string_view line) {
  const std::string_view content = trimmed(line);
  if (content.starts_with(trimmed(material_mark))) {
    std::string_view text = line.substr(line.find('|') + 1);
    if (text.starts_with(' ')) text.remove_prefix(1);
    material_text.append(text).push_back('\n');
  } else if (content.starts_with(wavelengths_mark)) {
    std::string_view rest = content.substr(wavelengths_mark.size());
    while (!(rest = trimmed(rest)).empty()) {
      const auto end = std::min(rest.find(' '), rest.size());
      if (const auto value = parse_number(rest.substr(0, end))) wavelengths_nm.push_back(*value);
      rest.remove_prefix(end);
    }
  } else if (content.starts_with(illuminant_mark)) {
    illuminant = trimmed(content.substr(illuminant_mark.size())) == name_of(Illuminant::d65)
                     ? Illuminant::d65
                     : Illuminant::equal_energy;
  }
}

}  // namespace brdftab

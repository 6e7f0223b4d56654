#include "host/model/fitted_intervals.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::string_view interval_mark = "95 %:", statistics_mark = "# condition number";

std::string_view next_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// Of `95 %: LOW to HIGH; ...`.
std::optional<FittedInterval> interval_of(std::string_view remark) {
  if (!remark.starts_with(interval_mark)) return {};
  const std::string_view interval =
      remark.substr(interval_mark.size(), remark.find(';') - interval_mark.size());
  const auto to = interval.find(" to ");
  if (to == interval.npos) return {};
  const auto low = parse_number(interval.substr(0, to)), high = parse_number(interval.substr(to + 4));
  if (!low || !high) return {};
  const auto flagged = [&](std::string_view flag) { return remark.find(flag) != remark.npos; };
  const bool is_open = flagged("unidentifiable") || flagged("no lower limit") || flagged("no upper limit");
  return FittedInterval{*low, *high, !is_open, std::string(remark)};
}

}  // namespace

std::vector<FittedIntervals> fitted_intervals(const Material& material) {
  struct Section {
    double wavelength_nm;
    FittedIntervals intervals;
  };
  std::vector<Section> sections{{NAN, {}}};  // [parameters], then each [[band]]
  std::string_view text = material.text();
  while (!text.empty()) {
    const std::string_view line = trimmed(next_line(text));
    if (line == "[[band]]") sections.push_back({NAN, sections.front().intervals});
    const auto equals = line.find('=');
    if (equals == line.npos || line.find('#') < equals) continue;
    const std::string_view name = trimmed(line.substr(0, equals));
    const std::string_view value = line.substr(equals + 1),
                           remark = value.substr(std::min(value.find('#'), value.size()));
    if (name == "wavelength_nm")
      sections.back().wavelength_nm = parse_number(value.substr(0, value.find('#'))).value_or(NAN);
    for (std::size_t p = 0; p < parameter_table.size(); ++p)
      if (name == parameter_table[p].name && !remark.empty())
        sections.back().intervals[p] = interval_of(trimmed(remark.substr(1)));
  }
  std::vector<FittedIntervals> bands;
  for (const Band& band : material.bands()) {
    const auto own = std::find_if(sections.begin(), sections.end(), [&](const Section& section) {
      return section.wavelength_nm == band.wavelength_nm;
    });
    bands.push_back((own == sections.end() ? sections.front() : *own).intervals);
  }
  return bands;
}

std::string fit_statistics(const Material& material) {
  std::string_view text = material.text();
  while (!text.empty()) {
    const std::string_view line = trimmed(next_line(text));
    if (line.starts_with(statistics_mark)) return std::string(line.substr(2));
  }
  return {};
}

}  // namespace brdftab

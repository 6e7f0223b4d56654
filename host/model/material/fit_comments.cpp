#include "host/model/material/fit_comments.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::string_view interval_mark = "95 %:", bounds_mark = "bounds ",
                           condition_mark = "# condition number of J^T J ", method_mark = "intervals by ";

std::string_view next_line(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// Of `LOW to HIGH`, up to a semicolon.
std::optional<FitRange> range_of(std::string_view words) {
  words = words.substr(0, words.find(';'));
  const auto to = words.find(" to ");
  if (to == words.npos) return {};
  const auto low = parse_number(words.substr(0, to)), high = parse_number(words.substr(to + 4));
  if (!low || !high) return {};
  return FitRange{*low, *high};
}

// Of `95 %: LOW to HIGH; bounds LOW to HIGH; FLAGS`.
std::optional<FittedParameter> fitted_of(std::string_view remark) {
  if (!remark.starts_with(interval_mark)) return {};
  const auto has = [&](std::string_view flag) { return remark.find(flag) != remark.npos; };
  const auto bounds = remark.find(bounds_mark);
  return FittedParameter{
      .interval = range_of(remark.substr(interval_mark.size())),
      .open_below = has("unidentifiable") || has("no lower limit"),
      .open_above = has("unidentifiable") || has("no upper limit"),
      .at_bound = has("at bound"),
      .bounds = bounds == remark.npos ? std::nullopt : range_of(remark.substr(bounds + bounds_mark.size()))};
}

// Of `# condition number of J^T J NUMBER; intervals by METHOD`.
void read_statistics(std::string_view line, FitRecord& record) {
  const std::string_view number = line.substr(condition_mark.size());
  record.condition = parse_number(number.substr(0, number.find(';')));
  const auto method = line.find(method_mark);
  if (method == line.npos) return;
  const std::string_view name = line.substr(method + method_mark.size());
  record.intervals = name == "profile likelihood" ? "profile" : name == "standard errors" ? "linear" : "";
}

}  // namespace

std::optional<FitRecord> fit_in_comments(const std::string& material, const std::vector<Band>& bands) {
  struct Section {
    std::optional<double> wavelength_nm;
    FittedParameters fitted;
  };
  std::vector<Section> sections{{}};  // [parameters], then each [[band]]
  FitRecord record{.level = 0.95};
  bool is_fitted = false;
  std::string_view text = material;
  while (!text.empty()) {
    const std::string_view line = trimmed(next_line(text));
    if (line == "[[band]]") sections.emplace_back();
    if (line.starts_with(condition_mark)) read_statistics(line, record);
    is_fitted = is_fitted || line.starts_with(condition_mark);
    const auto equals = line.find('=');
    if (equals == line.npos || line.find('#') < equals) continue;
    const std::string_view name = trimmed(line.substr(0, equals)), value = line.substr(equals + 1),
                           remark = value.substr(std::min(value.find('#'), value.size()));
    if (name == "wavelength_nm")
      sections.back().wavelength_nm = parse_number(value.substr(0, value.find('#')));
    for (std::size_t p = 0; p < parameter_table.size(); ++p)
      if (name == parameter_table[p].name && !remark.empty()) {
        auto& fitted = sections.back().fitted[p];
        fitted = fitted_of(trimmed(remark.substr(1)));
        is_fitted = is_fitted || fitted;
      }
  }
  if (!is_fitted) return std::nullopt;
  record.parameters = sections.front().fitted;
  for (const Band& band : bands) {
    const auto own = std::find_if(sections.begin() + 1, sections.end(), [&](const Section& section) {
      return section.wavelength_nm == band.wavelength_nm;
    });
    record.bands.push_back(own == sections.end() ? FittedParameters{} : own->fitted);
  }
  return record;
}

}  // namespace brdftab

#include "host/base/numbers.hpp"

#include <fmt/format.h>

#include <charconv>

namespace brdftab {
namespace {

template <class Number>
std::optional<Number> parse(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return std::nullopt;
  }
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<double> parse_number(std::string_view text) { return parse<double>(text); }
std::optional<long double> parse_long_number(std::string_view text) { return parse<long double>(text); }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const auto first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string shortest(double value) { return fmt::format("{}", value == 0 ? 0.0 : value); }

std::string excerpt(std::string_view text, std::size_t longest) {
  std::string result;
  for (const char c : text.substr(0, longest))
    result += (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) ? '?' : c;
  if (text.size() > longest) result += "...";
  return result;
}

}  // namespace brdftab

#include "host/formats/format_option.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

double number(const FormatOption& option, std::string_view text, bool is_whole) {
  const auto value = parse_number(text);
  const auto& range = option.range;
  if (!value || !std::isfinite(*value) || (is_whole && *value != std::floor(*value)) ||
      (range && !(*value >= range->low && *value <= range->high)))
    throw BadInput(GivenValue{option.name, excerpt(text)}, "must be a {}number{}", is_whole ? "whole " : "",
                   range ? fmt::format(" from {} to {}", range->low, range->high) : "");
  return *value;
}

}  // namespace

void FormatOption::set(std::string_view text) const {
  if (!words.empty() && std::find(words.begin(), words.end(), text) == words.end())
    throw BadInput(GivenValue{name, excerpt(text)}, "must be {}", fmt::join(words, " or "));
  std::visit(
      [&](auto* member) {
        using Member = std::remove_pointer_t<decltype(member)>;
        if constexpr (std::is_same_v<Member, std::string>)
          *member = text;
        else if constexpr (std::is_integral_v<Member>)
          *member = static_cast<Member>(number(*this, text, true));
        else
          *member = number(*this, text, false);
      },
      value);
}

}  // namespace brdftab

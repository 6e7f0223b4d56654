// Numbers as text, independent of the locale.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdftab {

/// The whole of text (blanks around it apart) as a number; none if it is anything else. nan and inf are
/// numbers here.
std::optional<double> parse_number(std::string_view text);
std::optional<long double> parse_long_number(std::string_view text);

std::string_view trimmed(std::string_view text);

/// The shortest decimal that reads back as the same double.
std::string shortest(double value);

/// A file's name or a value as it may stand in a message: one line, of bounded length.
std::string excerpt(std::string_view text, std::size_t longest = 60);

}  // namespace brdftab

// Text is written into XML so that it cannot end what it stands in.
#pragma once

#include <string>
#include <string_view>

namespace brdftab {

/// Gives text as it may stand between tags and in attributes, without control characters, which XML does not
/// have.
std::string xml_escaped(std::string_view text);

/// Gives a line as it may stand in a comment, which two hyphens would end.
std::string xml_comment(std::string_view line);
/// Gives the line that `xml_comment` made this of: XML itself leaves a comment as it is.
std::string xml_comment_line(std::string_view comment);

}  // namespace brdftab

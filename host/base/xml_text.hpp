// As much of XML as Radiance's BSDF files and SVG take.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brdftab {

/// Text as it may stand between tags and in attributes, without control characters, which XML does not have.
std::string xml_escaped(std::string_view text);
/// A line as it may stand in a comment, which two hyphens would end.
std::string xml_comment(std::string_view line);

/// A document, or a piece of one between two tags. Borrows the text.
class XmlText {
 public:
  /// `source`: the file's name, for messages.
  XmlText(std::string_view text, std::string source) : text_(text), source_(std::move(source)) {}

  /// What stands in each element of that name, in order; elements of one name do not nest.
  std::vector<XmlText> elements(std::string_view name) const;
  /// What stands in the first, without blanks around it. Throws BadInput where there is none.
  std::string_view text(std::string_view name) const;
  /// The lines of the first comment, as they were before `xml_comment`.
  std::vector<std::string> comment_lines() const;
  /// Throws BadInput `SOURCE: <NAME>: WHAT`.
  [[noreturn]] void refuse(std::string_view name, const std::string& what) const;

 private:
  std::string_view text_;
  std::string source_;
};

}  // namespace brdftab

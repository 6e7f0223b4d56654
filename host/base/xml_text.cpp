#include "host/base/xml_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::array<std::pair<char, std::string_view>, 5> entities{
    {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}, {'"', "&quot;"}, {'-', "&#45;"}}};

std::string replaced(std::string_view text, std::string_view marks) {
  std::string result;
  for (const char c : text) {
    std::string_view entity;
    for (const auto& [mark, name] : entities)
      if (c == mark && marks.find(c) != marks.npos) entity = name;
    if (c == '-' && !result.ends_with('-')) entity = {};
    entity.empty() ? result.push_back(c) : void(result += entity);
  }
  return result;
}

std::string restored(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    std::size_t length = 1;
    char c = text.front();
    for (const auto& [mark, name] : entities)
      if (text.starts_with(name)) {
        c = mark;
        length = name.size();
      }
    result += c;
    text.remove_prefix(length);
  }
  return result;
}

// Where the first element of that name lies, from the text after its opening tag to its closing tag; npos if
// there is none.
std::pair<std::size_t, std::size_t> find_element(std::string_view text, std::string_view name,
                                                 std::size_t from) {
  constexpr std::size_t none = std::string_view::npos;
  const std::string opening = fmt::format("<{}", name);
  for (std::size_t at = text.find(opening, from); at != none; at = text.find(opening, at + 1)) {
    const char after = at + opening.size() < text.size() ? text[at + opening.size()] : '\0';
    if (after != '>' && after != ' ' && after != '\n' && after != '\t') continue;
    const std::size_t begin = text.find('>', at);
    const std::size_t end = text.find(fmt::format("</{}>", name), at);
    if (begin == none || end == none || end < begin) return {none, none};
    return {begin + 1, end};
  }
  return {none, none};
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result = replaced(text, "&<>\"");
  std::erase_if(result, [](unsigned char c) { return c < 0x20 && c != '\n' && c != '\t'; });
  return result;
}

std::string xml_comment(std::string_view line) { return replaced(line, "&<-"); }

std::vector<XmlText> XmlText::elements(std::string_view name) const {
  std::vector<XmlText> found;
  for (auto [begin, end] = find_element(text_, name, 0); begin != std::string_view::npos;
       std::tie(begin, end) = find_element(text_, name, end))
    found.emplace_back(text_.substr(begin, end - begin), source_);
  return found;
}

std::string_view XmlText::text(std::string_view name) const {
  const auto [begin, end] = find_element(text_, name, 0);
  if (begin == std::string_view::npos) refuse(name, "is missing");
  return trimmed(text_.substr(begin, end - begin));
}

std::vector<std::string> XmlText::comment_lines() const {
  std::vector<std::string> lines;
  const std::size_t begin = text_.find("<!--");
  if (begin == text_.npos) return lines;
  std::string_view comment = text_.substr(begin + 4);
  comment = comment.substr(0, comment.find("-->"));
  while (!comment.empty()) {
    const std::size_t end = std::min(comment.find('\n'), comment.size());
    lines.push_back(restored(comment.substr(0, end)));
    comment.remove_prefix(std::min(end + 1, comment.size()));
  }
  return lines;
}

void XmlText::refuse(std::string_view name, const std::string& what) const {
  throw BadInput("{}: <{}>: {}", source_, name, what);
}

}  // namespace brdftab

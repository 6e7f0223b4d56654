#include "host/base/xml_text.hpp"

#include <array>
#include <utility>

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

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string result = replaced(text, "&<>\"");
  std::erase_if(result, [](unsigned char c) { return c < 0x20 && c != '\n' && c != '\t'; });
  return result;
}

std::string xml_comment(std::string_view line) { return replaced(line, "&<-"); }

std::string xml_comment_line(std::string_view comment) {
  std::string result;
  while (!comment.empty()) {
    std::size_t length = 1;
    char c = comment.front();
    for (const auto& [mark, name] : entities)
      if (comment.starts_with(name)) {
        c = mark;
        length = name.size();
      }
    result += c;
    comment.remove_prefix(length);
  }
  return result;
}

}  // namespace brdftab

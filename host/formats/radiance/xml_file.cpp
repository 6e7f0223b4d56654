#include "host/formats/radiance/xml_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/base/whole_file.hpp"

namespace brdftab {
namespace {

// Names are taken without the prefix of a namespace, which each file chooses for itself.
bool is_called(const pugi::xml_node& node, std::string_view name) {
  const std::string_view whole = node.name();
  return node.type() == pugi::node_element && whole.substr(whole.find(':') + 1) == name;
}

// Calls `visit` for every node inside, in the order of the file.
void walk(const pugi::xml_node& node, const std::function<void(const pugi::xml_node&)>& visit) {
  for (const pugi::xml_node& child : node.children()) {
    visit(child);
    walk(child, visit);
  }
}

}  // namespace

std::vector<XmlElement> XmlElement::elements(std::string_view name) const {
  std::vector<XmlElement> found;
  walk(node_, [&](const pugi::xml_node& node) {
    if (is_called(node, name)) found.emplace_back(file_, node);
  });
  return found;
}

pugi::xml_node XmlElement::first(std::string_view name) const {
  return node_.find_node([&](const pugi::xml_node& node) { return is_called(node, name); });
}

std::string XmlElement::text(std::string_view name) const {
  const pugi::xml_node element = first(name);
  if (!element) refuse(name, "is missing");
  // A comment parts a text in two.
  std::string text;
  for (const pugi::xml_node& child : element.children())
    if (child.type() == pugi::node_pcdata || child.type() == pugi::node_cdata) text += child.value();
  return std::string(trimmed(text));
}

void XmlElement::refuse(std::string_view name, std::string_view what) const {
  const pugi::xml_node element = first(name);
  throw BadInput("{}: <{}>: {}", file_.where((element ? element : node_).offset_debug()), name, what);
}

XmlFile::XmlFile(const std::filesystem::path& file) : name_(file.string()), text_(read_whole(file)) {
  const pugi::xml_parse_result result =
      document_.load_buffer(text_.data(), text_.size(), pugi::parse_default | pugi::parse_comments);
  if (!result) throw BadInput("{}: is not XML: {}", where(result.offset), result.description());
}

std::vector<std::string> XmlFile::comments() const {
  std::vector<std::string> found;
  walk(document_, [&](const pugi::xml_node& node) {
    if (node.type() == pugi::node_comment) found.emplace_back(node.value());
  });
  return found;
}

std::string XmlFile::where(std::ptrdiff_t offset) const {
  const auto end = text_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, std::ssize(text_));
  return fmt::format("{}:{}", name_, 1 + std::count(text_.begin(), end, '\n'));
}

}  // namespace brdftab

// An XML file of another program is read by pugixml. Its refusals say where in the file they are.
#pragma once

#include <pugixml.hpp>

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace brdftab {

class XmlFile;

/// An element borrows its file.
class XmlElement {
 public:
  XmlElement(const XmlFile& file, pugi::xml_node node) : file_(file), node_(node) {}

  /// Gives the elements of that name inside it, at any depth, in the order of the file.
  std::vector<XmlElement> elements(std::string_view name) const;
  /// Gives the text of the first such element, without blanks around it. Throws BadInput where there is none.
  std::string text(std::string_view name) const;
  /// Throws BadInput `FILE:LINE: <NAME>: WHAT` for the first element of that name inside it.
  [[noreturn]] void refuse(std::string_view name, std::string_view what) const;

 private:
  pugi::xml_node first(std::string_view name) const;

  const XmlFile& file_;
  pugi::xml_node node_;
};

class XmlFile {
 public:
  /// Throws FileError where the file cannot be read, and BadInput `FILE:LINE: ...` where it is not XML.
  explicit XmlFile(const std::filesystem::path& file);

  XmlElement root() const { return {*this, document_}; }
  /// Gives the text of every comment, in the order of the file.
  std::vector<std::string> comments() const;

  /// Writes FILE:LINE of a place, which counts in bytes from the file's beginning.
  std::string where(std::ptrdiff_t offset) const;

 private:
  std::string name_;
  std::string text_;
  pugi::xml_document document_;
};

}  // namespace brdftab

// A TOML text whose every fault is told with its place and with what is allowed there.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>
#include <vector>

#include "host/base/error.hpp"

namespace brdftab {

/// The functions that read a value throw BadInput `FILE:LINE:COLUMN: KEY = VALUE: what is allowed` where it
/// is not as asked. A key's name is that of the whole path, as parameters.n_eff.
class TomlDocument {
 public:
  /// `source` stands for the file's name in messages. The text must outlive the document. Throws BadInput
  /// where it is no TOML.
  TomlDocument(const std::string& text, std::string source);

  const toml::table& root() const { return root_; }

  /// Refuses what the place is for.
  [[noreturn]] void refuse(const toml::source_region& where, const std::string& what) const;
  /// Refuses a value.
  [[noreturn]] void refuse(std::string_view name, const toml::node& node, const std::string& allowed) const;

  /// Refuses the first key of the table that is not among those known, and names the nearest of them.
  /// `prefix` is the path of the table, as "parameters.".
  void check_keys(const toml::table& table, std::string_view prefix,
                  const std::vector<std::string_view>& known) const;

  /// One line of text; empty where the key is absent.
  std::string text(const toml::table& table, std::string_view prefix, std::string_view key) const;
  /// None where the key is absent.
  const toml::table* optional_table(const toml::table& table, std::string_view prefix,
                                    std::string_view key) const;

  std::string text(std::string_view name, const toml::node& node) const;
  /// Finite; `allowed` says what else is asked of it.
  double number(std::string_view name, const toml::node& node, std::string_view allowed) const;
  /// From minimum to maximum, both included.
  double number(std::string_view name, const toml::node& node, double minimum, double maximum) const;
  std::size_t count(std::string_view name, const toml::node& node) const;
  bool boolean(std::string_view name, const toml::node& node) const;
  /// The index of a string among the choices; true and false are booleans in the file.
  std::size_t choice(std::string_view name, const toml::node& node,
                     const std::vector<std::string_view>& choices) const;
  const toml::array& array(std::string_view name, const toml::node& node, const std::string& allowed) const;

 private:
  void check_is_text(const std::string& text) const;
  std::string place(const toml::source_region& where) const;
  std::string value_text(const toml::node& node) const;

  std::string source_;
  std::vector<std::string_view> lines_;
  toml::table root_;
};

}  // namespace brdftab

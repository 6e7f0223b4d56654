// The format that `generate` writes, and the options of all formats.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <utility>
#include <vector>

#include "host/formats/registry.hpp"

namespace brdftab {

/// Makes an option of the command line from a format's row.
CLI::Option* add_format_option(CLI::App& parser, const FormatOption& row);

class FormatChoice {
 public:
  FormatChoice() : formats_(all_formats()) {}

  /// The formats that can be written, with their extensions, in words.
  std::string known() const;

  /// Adds the options of the dense tables' formats, in the group at hand.
  void add_dense_options(CLI::App& parser);
  /// Adds the options of the simulators' formats, a group for each.
  void add_export_options(CLI::App& parser);

  /// The format that `name` names or, where it is empty, the output's extension tells. In a folder it is the
  /// one whose option was given, or HDF5. Throws BadInput.
  const Format& find(const std::string& name, const std::string& output, bool is_folder) const;

  /// Throws BadInput where an option of another format than the chosen one was given.
  void check(const Format& chosen) const;

 private:
  void add_options(CLI::App& parser, Format& format);
  const Format* format_of_given_option() const;

  Formats formats_;
  std::vector<std::pair<const CLI::Option*, const Format*>> options_;
};

}  // namespace brdftab

// A setting of a file format is a row, of which each user of the library makes what its own users know.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace brdftab {

/// The command line makes an option `--rgl-samples` of a row `rgl_samples`, and Python a keyword argument.
struct FormatOption {
  /// Both ends are allowed.
  struct Range {
    double low, high;
  };

  std::string name;
  std::string help;
  /// The member of the format that keeps the value; until a value is set, it is the default.
  std::variant<std::string*, int*, std::size_t*, double*, std::optional<double>*> value;
  /// The words that are allowed; empty: any text, or a number.
  std::vector<std::string_view> words = {};
  /// A number lies in it.
  std::optional<Range> range = {};
  /// Shows what a text looks like, for help: "deflate[:LEVEL]".
  std::string_view shape = {};
  /// A reader of the format takes it as well, since its files do not say it.
  bool is_for_reading = false;

  /// Sets the value. Throws BadInput, which names the setting and what it allows.
  void set(std::string_view text) const;
};

}  // namespace brdftab

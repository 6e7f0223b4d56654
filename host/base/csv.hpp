// Rows of comma-separated values under a header; `#` lines and empty ones are ignored.
#pragma once

#include <istream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdftab {

class Csv {
 public:
  /// Reads the header. Throws BadInput `SOURCE:1: is empty; ...` where there is none; `wanted` says what it
  /// should name.
  Csv(std::istream& in, std::string source, std::string_view wanted);

  /// The next row, or none. Throws BadInput where it has not as many cells as the header.
  const std::vector<std::string_view>* next();

  /// The column of that name, if there is one. Throws BadInput where it appears twice.
  std::optional<std::size_t> column(std::string_view name) const;
  const std::string& name(std::size_t column) const { return header_[column]; }

  /// `SOURCE:LINE` of the row, or of the header before the first.
  std::string where() const;
  std::size_t line() const { return line_; }

 private:
  bool advance();

  std::istream& in_;
  std::string source_;
  std::size_t line_ = 0;
  std::string text_;
  std::vector<std::string_view> cells_;
  std::vector<std::string> header_;
};

}  // namespace brdftab

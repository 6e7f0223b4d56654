// Reads rows of comma-separated values under a header, with quotes as RFC 4180 has them: "red, wet". Lines
// that begin with `#` and empty ones are ignored.
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

  /// Gives the next row, or none. Throws BadInput where it has not as many cells as the header.
  const std::vector<std::string_view>* next();

  /// Finds the column of that name, if there is one. Throws BadInput where it appears twice.
  std::optional<std::size_t> column(std::string_view name) const;
  const std::string& name(std::size_t column) const { return header_[column]; }

  /// Writes `SOURCE:LINE` of the row, or of the header before the first.
  std::string where() const;
  std::size_t line() const { return line_; }

 private:
  /// Where a cell lies in `text_`.
  struct Place {
    std::size_t begin, length;
    bool is_quoted;
  };

  bool advance();
  /// Cuts the row in `text_` into cells, from a position on.
  void split(std::size_t at);
  /// Takes a quoted cell, which may reach over several lines. Its content, which is shorter than what is
  /// written, moves to where the quote is. Returns the position of the comma after it, or npos.
  std::size_t unquote(std::size_t opening);

  std::istream& in_;
  std::string source_;
  std::size_t line_ = 0;   // where the row begins
  std::size_t lines_ = 0;  // read so far
  std::string text_;
  std::vector<Place> places_;
  std::vector<std::string_view> cells_;
  std::vector<std::string> header_;
};

}  // namespace brdftab

#include "host/base/csv.hpp"

#include <algorithm>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::string_view blanks = " \t\r";

}  // namespace

Csv::Csv(std::istream& in, std::string source, std::string_view wanted)
    : in_(in), source_(std::move(source)) {
  if (!advance()) throw BadInput("{}:1: is empty; a header must name {}", source_, wanted);
  header_.assign(cells_.begin(), cells_.end());
}

const std::vector<std::string_view>* Csv::next() {
  if (!advance()) return nullptr;
  if (cells_.size() != header_.size())
    throw BadInput("{}: has {} cells where the header has {}", where(), cells_.size(), header_.size());
  return &cells_;
}

std::optional<std::size_t> Csv::column(std::string_view name) const {
  const auto at = std::find(header_.begin(), header_.end(), name);
  if (at == header_.end()) return std::nullopt;
  if (std::count(header_.begin(), header_.end(), name) > 1)
    throw BadInput("{}: the column {} appears twice", where(), name);
  return static_cast<std::size_t>(at - header_.begin());
}

std::string Csv::where() const { return fmt::format("{}:{}", source_, line_); }

bool Csv::advance() {
  while (std::getline(in_, text_)) {
    line_ = ++lines_;
    const std::size_t begin = line_ == 1 && text_.starts_with("\xef\xbb\xbf") ? 3 : 0;
    const std::string_view content = trimmed(std::string_view(text_).substr(begin));
    if (content.empty() || content.starts_with('#')) continue;
    split(begin);
    return true;
  }
  return false;
}

void Csv::split(std::size_t at) {
  places_.clear();
  for (std::size_t comma = 0; comma != std::string::npos; at = comma + 1) {
    const std::size_t first = text_.find_first_not_of(blanks, at);
    if (first != std::string::npos && text_[first] == '"') {
      comma = unquote(first);
    } else {
      comma = text_.find(',', at);
      places_.push_back({at, std::min(comma, text_.size()) - at, false});
    }
  }
  cells_.clear();
  for (const Place& place : places_) {
    const std::string_view cell = std::string_view(text_).substr(place.begin, place.length);
    cells_.push_back(place.is_quoted ? cell : trimmed(cell));
  }
}

std::size_t Csv::unquote(std::size_t opening) {
  std::size_t from = opening + 1, to = opening;
  for (;; ++from) {
    while (from == text_.size()) {
      std::string line;
      if (!std::getline(in_, line)) throw BadInput("{}: a quote is not closed", where());
      ++lines_;
      text_ += '\n' + line;
    }
    if (text_[from] == '"') {
      if (from + 1 == text_.size() || text_[from + 1] != '"') break;
      ++from;
    }
    text_[to++] = text_[from];
  }
  places_.push_back({opening, to - opening, true});
  const std::size_t next = text_.find_first_not_of(blanks, from + 1);
  if (next != std::string::npos && text_[next] != ',')
    throw BadInput("{}: text follows a closing quote: {}", where(),
                   excerpt(std::string_view(text_).substr(next)));
  return next;
}

}  // namespace brdftab

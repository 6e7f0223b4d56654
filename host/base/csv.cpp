#include "host/base/csv.hpp"

#include <algorithm>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {

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
    ++line_;
    std::string_view content = text_;
    if (line_ == 1 && content.starts_with("\xef\xbb\xbf")) content.remove_prefix(3);
    if (trimmed(content).empty() || trimmed(content).starts_with('#')) continue;
    cells_.clear();
    for (auto comma = content.find(','); comma != std::string_view::npos; comma = content.find(',')) {
      cells_.push_back(trimmed(content.substr(0, comma)));
      content.remove_prefix(comma + 1);
    }
    cells_.push_back(trimmed(content));
    return true;
  }
  return false;
}

}  // namespace brdftab

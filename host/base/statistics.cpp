#include "host/base/statistics.hpp"

#include <algorithm>

namespace brdftab {
namespace {

double value_of_rank(std::vector<double>& values, std::size_t rank) {
  if (values.empty()) return 0;
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

double percentile(std::vector<double>& values, std::size_t percent) {
  const std::size_t rank = values.size() * percent / 100;
  return value_of_rank(values, percent < 100 ? rank : rank - 1);
}

double lower_percentile(std::vector<double>& values, std::size_t percent) {
  return value_of_rank(values, (values.size() - 1) * percent / 100);
}

}  // namespace brdftab

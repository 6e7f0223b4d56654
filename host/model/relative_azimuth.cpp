#include "host/model/relative_azimuth.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

constexpr std::size_t most_pieces_of_a_row = 2;  // it may pass the end of the circle once

// The remainder is exact; the ends of the circle are one node.
std::vector<double> differences(double phi_i, const Axis& phi_s) {
  std::vector<double> phi;
  for (const double s : phi_s.nodes()) {
    const double difference = std::remainder(s - phi_i, 360.0);
    phi.push_back(difference == -180 ? 180 : difference);
  }
  return phi;
}

[[noreturn]] void refuse(const std::string& why) {
  throw BadInput(
      "--layout virtual: {}; a view takes even steps of phi_i and phi_s that binary numbers hold exactly, "
      "such as whole degrees, 0.5 or 0.25, but not 0.1",
      why);
}

Axis distinct_differences(const Axis& phi_i, const Axis& phi_s) {
  std::vector<double> all;
  for (const double i : phi_i.nodes()) {
    std::vector<double> row = differences(i, phi_s);
    std::sort(row.begin(), row.end());
    row.erase(std::unique(row.begin(), row.end()), row.end());
    if (std::all_of(row.begin(), row.end(),
                    [&](double phi) { return std::binary_search(all.begin(), all.end(), phi); }))
      continue;
    std::vector<double> merged;
    std::set_union(all.begin(), all.end(), row.begin(), row.end(), std::back_inserter(merged));
    all = std::move(merged);
    if (all.size() > longest_axis)
      refuse(fmt::format("phi_s - phi_i takes more than {} values", longest_axis));
  }
  return Axis(AxisKind::phi_s, std::move(all));
}

}  // namespace

RelativeAzimuth relative_azimuth(const Axis& phi_i, const Axis& phi_s) {
  RelativeAzimuth result{distinct_differences(phi_i, phi_s), {}};
  const auto axis = result.phi.nodes();
  for (std::size_t i = 0; i < phi_i.size(); ++i) {
    std::vector<std::size_t> node;
    for (const double phi : differences(phi_i[i], phi_s))
      node.push_back(
          static_cast<std::size_t>(std::lower_bound(axis.begin(), axis.end(), phi) - axis.begin()));
    std::size_t pieces = 0;
    for (std::size_t begin = 0; begin < node.size(); ++pieces) {
      std::size_t end = begin + 1;
      const std::size_t step = end < node.size() && node[end] > node[begin] ? node[end] - node[begin] : 1;
      while (end < node.size() && node[end] == node[end - 1] + step) ++end;
      result.pieces.push_back({i, begin, node[begin], step, end - begin});
      begin = end;
    }
    if (pieces > most_pieces_of_a_row)
      refuse(
          fmt::format("phi_s - phi_i takes {} different values for {} by {} nodes, and those of phi_i = {} "
                      "are not evenly spaced among them",
                      axis.size(), phi_i.size(), phi_s.size(), shortest(phi_i[i])));
  }
  return result;
}

}  // namespace brdftab

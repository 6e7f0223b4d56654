// A list of direction pairs, from CSV.
#pragma once

#include <istream>
#include <string>
#include <vector>

#include "host/base/csv.hpp"

namespace brdftab {

/// Angles in degrees as the file gives them, and as the model takes them.
struct DirectionPair {
  double theta_i;
  double theta_s;  // as given; negative: the backward side in plane
  double phi;      // as given
  std::size_t line;

  double model_theta_s() const { return theta_s < 0 ? -theta_s : theta_s; }
  double model_phi() const { return theta_s < 0 ? phi + 180 : phi; }
};

/// The columns theta_i_deg, theta_s_deg and phi_deg (or phi_s_deg, with phi_i_deg if there is one) of a CSV
/// file.
class DirectionColumns {
 public:
  /// Throws BadInput where one is missing.
  explicit DirectionColumns(const Csv& csv);
  /// Throws BadInput `SOURCE:LINE: ...` where an angle is not a number in its range.
  DirectionPair read(const Csv& csv, const std::vector<std::string_view>& cells) const;

 private:
  std::optional<std::size_t> theta_i_, theta_s_, phi_, phi_s_, phi_i_;
};

/// Reads CSV with those columns, in any order; `#` lines and other columns are ignored. Throws BadInput with
/// `SOURCE:LINE: ...`.
std::vector<DirectionPair> read_directions(std::istream& in, const std::string& source);

}  // namespace brdftab

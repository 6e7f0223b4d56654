// Where a fit integrates N: at its polar angles or, where many lie close together, at fewer nodes between
// which it is interpolated.
#pragma once

#include <span>
#include <vector>

namespace brdftab {

/// Angles are spread over t = artanh(sin theta), as in NormalizationCurve; there N and its derivatives by the
/// parameters are analytic. Angles close together make a panel; where it has more angles than Chebyshev nodes
/// are needed, polynomials through those give N at the angles: ln f and its derivatives are within 1e-9 for
/// 40 random materials such as a fit may give. Elsewhere the angles themselves are the nodes, and nothing is
/// interpolated.
class NormalizationNodes {
 public:
  /// Distinct polar angles from 0 to below 90, degrees, in any order.
  explicit NormalizationNodes(std::span<const double> theta);

  bool interpolates() const { return interpolates_; }
  /// Degrees; in the order of the angles where nothing is interpolated.
  const std::vector<double>& theta() const { return theta_; }

  /// N at angle k is the sum over j of share[k * width + j] times N at node first[k] + j, where j < count[k].
  static constexpr int width = 16;
  const std::vector<int>& first() const { return first_; }
  const std::vector<int>& count() const { return count_; }
  const std::vector<double>& share() const { return share_; }

 private:
  bool interpolates_ = false;
  std::vector<double> theta_;
  std::vector<int> first_, count_;
  std::vector<double> share_;
};

}  // namespace brdftab

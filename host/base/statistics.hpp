// Percentiles of a list of values.
#pragma once

#include <cstddef>
#include <vector>

namespace brdftab {

/// The one of n values that has floor(n percent/100) of them below it in increasing order; 100 is the
/// largest. For the median of an even number it is the upper of the two in the middle. 0 where there are no
/// values. Reorders them; none may be nan.
double percentile(std::vector<double>& values, std::size_t percent);

/// The same with floor((n - 1) percent/100) of them below it: for the median of an even number it is the
/// lower of the two in the middle. The errors of exported files and the doubts about measured values are told
/// by it.
double lower_percentile(std::vector<double>& values, std::size_t percent);

inline double median(std::vector<double>& values) { return percentile(values, 50); }

}  // namespace brdftab

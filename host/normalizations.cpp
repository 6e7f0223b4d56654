#include "host/normalizations.hpp"

#include <algorithm>
#include <cmath>

#include "host/error.hpp"
#include "host/numbers.hpp"

namespace brdftab {

double Normalizations::largest_error() const {
  double largest = 0;
  for (const auto& errors : error)
    for (const double e : errors) largest = std::max(largest, e);
  return largest;
}

Normalizations normalizations(const Engine& engine, const Band& band, const ModelSwitches& switches,
                              std::span<const double> theta) {
  const std::size_t bytes = 3 * theta.size() * bytes_of(engine.working());
  const cl::Buffer angles = engine.upload(theta);
  const cl::Buffer errors = engine.buffer(bytes);
  Normalizations result;
  result.on_device = engine.buffer(bytes);
  cl::Kernel kernel = engine.kernel("normalizations");
  set_arguments(kernel, angles, result.on_device, errors);
  KernelMaterial(band.parameters, switches, engine.working()).set(kernel, 3);
  engine.run_items(kernel, {theta.size(), 3, 1});
  const auto values = engine.download(result.on_device, 3 * theta.size());
  const auto estimates = engine.download(errors, 3 * theta.size());
  for (std::size_t lobe = 0; lobe < 3; ++lobe) {
    const auto first = static_cast<std::ptrdiff_t>(lobe * theta.size());
    const auto last = first + static_cast<std::ptrdiff_t>(theta.size());
    result.value[lobe].assign(values.begin() + first, values.begin() + last);
    result.error[lobe].assign(estimates.begin() + first, estimates.begin() + last);
    for (std::size_t k = 0; k < theta.size(); ++k)
      if (!std::isfinite(result.value[lobe][k]) || !std::isfinite(result.error[lobe][k]))
        throw BadInput("N of the {} lobe is not finite at theta = {} degrees: rho_{} = {}, w = {} and n = {} leave it no width",
                       lobe_names[lobe], shortest(theta[k]), lobe_names[lobe],
                       shortest(band.parameters.*parameter_table[3 + 2 * lobe].member), shortest(band.parameters.w),
                       shortest(band.parameters.n));
  }
  return result;
}

}  // namespace brdftab

#include "host/normalizations.hpp"

#include <algorithm>
#include <cmath>

#include "host/error.hpp"
#include "host/interrupt.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// Few enough that an interruption need not wait long.
constexpr std::size_t angles_at_once = 128;

}  // namespace

double Normalizations::largest_error() const {
  double largest = 0;
  for (const auto& errors : error)
    for (const double e : errors) largest = std::max(largest, e);
  return largest;
}

void run_by_angle(const Engine& engine, const cl::Kernel& kernel, std::size_t angles) {
  for (std::size_t begin = 0; begin < angles; begin += angles_at_once) {
    stop_if_interrupted();
    engine.run_items(kernel, {std::min(angles_at_once, angles - begin), 3, 1}, begin);
    engine.queue().finish();
  }
}

Normalizations normalizations(const Engine& engine, const Band& band, const ModelSwitches& switches,
                              std::span<const double> theta) {
  const std::size_t bytes = 3 * theta.size() * bytes_of(engine.working());
  const cl::Buffer angles = engine.upload_polar_angles(theta);
  const cl::Buffer errors = engine.buffer(bytes);
  Normalizations result;
  result.on_device = engine.buffer(bytes);
  cl::Kernel kernel = engine.kernel("normalizations");
  set_arguments(kernel, angles, static_cast<cl_int>(theta.size()), result.on_device, errors);
  KernelMaterial(band.parameters, switches, engine.working()).set(kernel, 4);
  run_by_angle(engine, kernel, theta.size());
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

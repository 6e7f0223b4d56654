#include "host/compute/normalizations.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"

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
    engine.watch().stop_if_asked();
    engine.run_items(kernel, {std::min(angles_at_once, angles - begin), 3, 1}, begin);
    engine.queue().finish();
  }
}

std::array<std::vector<double>, 3> download_by_lobe(const Engine& engine, const cl::Buffer& buffer,
                                                    std::size_t angles) {
  const auto values = engine.download(buffer, 3 * angles);
  std::array<std::vector<double>, 3> result;
  for (std::size_t lobe = 0; lobe < 3; ++lobe) {
    const auto first = values.begin() + static_cast<std::ptrdiff_t>(lobe * angles);
    result[lobe].assign(first, first + static_cast<std::ptrdiff_t>(angles));
  }
  return result;
}

void refuse_not_finite(std::string_view quantity, std::size_t lobe, double theta,
                       const Parameters& parameters) {
  const auto& rho = parameter_table[3 + 2 * lobe];
  throw BadInput(
      "{} of the {} lobe is not finite at theta = {} degrees: {} = {}, w = {} and n = {} leave it no width",
      quantity, lobe_names[lobe], shortest(theta), rho.name, shortest(parameters.*rho.member),
      shortest(parameters.w), shortest(parameters.n));
}

Normalizations normalizations(const Engine& engine, const Band& band, const Variant& variant,
                              std::span<const double> theta) {
  const std::size_t bytes = 3 * theta.size() * bytes_of(engine.working());
  const cl::Buffer angles = engine.upload_polar_angles(theta);
  const cl::Buffer errors = engine.buffer(bytes);
  Normalizations result;
  result.on_device = engine.buffer(bytes);
  cl::Kernel kernel = engine.kernel("normalizations");
  set_arguments(kernel, angles, static_cast<cl_int>(theta.size()), result.on_device, errors);
  KernelMaterial(band.parameters, variant, engine.working()).set(kernel, 4);
  run_by_angle(engine, kernel, theta.size());
  result.value = download_by_lobe(engine, result.on_device, theta.size());
  result.error = download_by_lobe(engine, errors, theta.size());
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    for (std::size_t k = 0; k < theta.size(); ++k)
      if (!std::isfinite(result.value[lobe][k]) || !std::isfinite(result.error[lobe][k]))
        refuse_not_finite("N", lobe, theta[k], band.parameters);
  return result;
}

}  // namespace brdftab

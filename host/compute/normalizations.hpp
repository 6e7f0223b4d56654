// N of each lobe at a list of polar angles, integrated on the device.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "host/compute/opencl/engine.hpp"
#include "host/model/material.hpp"

namespace brdftab {

struct Normalizations {
  /// N by lobe and angle, and its estimated relative error.
  std::array<std::vector<double>, 3> value;
  std::array<std::vector<double>, 3> error;
  /// The same values on the device, [lobe][angle], in the working precision.
  cl::Buffer on_device;

  double largest_error() const;
};

/// Runs a kernel over angles x lobes, in pieces between which an interruption is answered.
void run_by_angle(const Engine& engine, const cl::Kernel& kernel, std::size_t angles);

/// What such a kernel wrote, [lobe][angle], by lobe; waits for the queue.
std::array<std::vector<double>, 3> download_by_lobe(const Engine& engine, const cl::Buffer& buffer,
                                                    std::size_t angles);

/// Throws BadInput that names the lobe, the polar angle in degrees and the parameters that leave `quantity`
/// not finite.
[[noreturn]] void refuse_not_finite(std::string_view quantity, std::size_t lobe, double theta,
                                    const Parameters& parameters);

/// Polar angles in degrees. Throws BadInput, which names lobe, angle and parameters, where N is not finite.
Normalizations normalizations(const Engine& engine, const Band& band, const Variant& variant,
                              std::span<const double> theta);

}  // namespace brdftab

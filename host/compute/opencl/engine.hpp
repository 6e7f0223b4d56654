// A device with the kernels built for it: one program for each pair of working and table precision.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "host/base/watch.hpp"
#include "host/compute/opencl/device.hpp"
#include "host/model/parameters.hpp"
#include "host/model/precision.hpp"

namespace brdftab {

/// A material as kernel arguments, in an engine's working precision.
class KernelMaterial {
 public:
  KernelMaterial(const Parameters&, const Variant&, Precision working);
  /// Sets the arguments MaterialConstants and ModelVariant from `first` on.
  void set(cl::Kernel& kernel, cl_uint first) const;

 private:
  std::vector<std::byte> constants_;
  std::vector<std::byte> variant_;
};

class Engine {
 public:
  /// Builds the kernels. Throws Error (exit status 3): a float64 table on a device without fp64, or a failed
  /// build, with its log.
  /// `directions_width`: pairs of directions in a work-item, 1, 2, 4, 8 or 16; 0: what suits the device.
  /// Long work over the engine follows `watch`.
  Engine(Device device, Precision working, Precision table, Watch watch = {},
         std::size_t directions_width = 0);

  /// The working precision that a device allows.
  static Precision widest(const Device& device) {
    return device.has_fp64 ? Precision::float64 : Precision::float32;
  }

  const Device& device() const { return device_; }
  const Watch& watch() const { return watch_; }
  Precision working() const { return working_; }
  Precision table() const { return table_; }
  const std::string& build_options() const { return build_options_; }
  const cl::Context& context() const { return context_; }
  const cl::CommandQueue& queue() const { return queue_; }

  cl::Kernel kernel(const char* name) const { return cl::Kernel(program_, name); }
  /// A kernel over lists of pairs of directions, each work-item of which takes directions_width() pairs.
  cl::Kernel directions_kernel(const char* name) const;
  /// A kernel of kernels/gradients.cl, of the same width.
  cl::Kernel gradient_kernel(const char* name) const;
  std::size_t directions_width() const { return directions_width_; }
  /// `count` filled up to whole work-groups, so that PoCL compiles such a kernel for one local size.
  std::size_t padded_directions(std::size_t count) const;
  /// Enqueues such a kernel over a list filled up so.
  void run_directions(const cl::Kernel& kernel, std::size_t padded) const;

  /// An uninitialised buffer; at least one byte long.
  cl::Buffer buffer(std::size_t bytes) const;
  /// A buffer of numbers in one precision, by default the working one.
  cl::Buffer upload(std::span<const double> values, Precision precision) const;
  cl::Buffer upload(std::span<const double> values) const { return upload(values, working_); }
  cl::Buffer upload(std::span<const int> values) const { return upload(std::as_bytes(values)); }
  cl::Buffer upload(std::span<const std::byte> bytes) const;
  /// Sets a kernel's argument, a number in one precision.
  static void set_number(cl::Kernel& kernel, cl_uint index, Precision precision, double value);
  /// Throws BadInput where the working precision would round a polar angle, in degrees, to 90.
  void check_polar_angles(std::span<const double> theta) const;
  /// Polar angles that pass that check.
  cl::Buffer upload_polar_angles(std::span<const double> theta) const;
  /// Reads numbers in the working precision; waits for the queue.
  std::vector<double> download(const cl::Buffer& buffer, std::size_t count) const;
  std::vector<int> download_ints(const cl::Buffer& buffer, std::size_t count) const;

  /// Enqueues a range; x is the fastest dimension. Work-groups run along it, as long as the device allows,
  /// for PoCL vectorises long ones best; where they do not divide x, the last one repeats some of the work of
  /// the one before.
  void run(const cl::Kernel& kernel, std::array<std::size_t, 3> size) const;
  /// A range of few or uneven work-items: on a CPU each is a work-group, so that all cores share them and
  /// PoCL, which compiles a kernel anew for each size of work-group, does so once.
  void run_items(const cl::Kernel& kernel, std::array<std::size_t, 3> size, std::size_t first_x = 0) const;

 private:
  cl::Program build(const std::string& options) const;

  Device device_;
  Precision working_;
  Precision table_;
  Watch watch_;
  std::string build_options_;
  cl::Context context_;
  cl::CommandQueue queue_;
  cl::Program program_;
  std::size_t directions_width_;
  mutable cl::Program directions_;  // built when first asked for
  mutable cl::Program gradients_;   // the same
};

/// Sets a kernel's arguments in order. A kernel does not keep its buffers: they must live until it is
/// enqueued.
template <class... Args>
void set_arguments(cl::Kernel& kernel, const Args&... arguments) {
  cl_uint index = 0;
  (kernel.setArg(index++, arguments), ...);
}

}  // namespace brdftab

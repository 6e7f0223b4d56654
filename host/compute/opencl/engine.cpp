#include "host/compute/opencl/engine.hpp"

#include <algorithm>
#include <cstring>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/on_host/kernel_constants.hpp"
#include "host/compute/opencl/kernel_source.hpp"
#include "host/compute/opencl/pocl_cache.hpp"

namespace brdftab {
namespace {

// Work-items in a work-group over lists of directions: of many directions each on a CPU, of one on a GPU.
std::size_t directions_group(const Device& device) { return device.is_gpu ? 64 : 16; }

template <class Struct>
std::vector<std::byte> bytes(const Struct& value) {
  std::vector<std::byte> result(sizeof(Struct));
  std::memcpy(result.data(), &value, sizeof(Struct));
  return result;
}

}  // namespace

KernelMaterial::KernelMaterial(const Parameters& parameters, const Variant& variant, Precision working)
    : constants_(working == Precision::float64
                     ? bytes(material_constants<kernel_f64::MaterialConstants>(parameters))
                     : bytes(material_constants<kernel_f32::MaterialConstants>(parameters))),
      variant_(bytes(model_variant<kernel_f64::ModelVariant>(variant))) {}

void KernelMaterial::set(cl::Kernel& kernel, cl_uint first) const {
  kernel.setArg(first, constants_.size(), constants_.data());
  kernel.setArg(first + 1, variant_.size(), variant_.data());
}

Engine::Engine(Device device, Precision working, Precision table, Watch watch, std::size_t directions_width)
    : device_(std::move(device)),
      working_(working),
      table_(table),
      watch_(std::move(watch)),
      directions_width_(directions_width) {
  if ((working == Precision::float64 || table == Precision::float64) && !device_.has_fp64)
    throw Error(Fault::device, "{} has no fp64: it takes --precision float32 only", device_.name);
  build_options_ = fmt::format("-cl-std=CL1.2 -DBRDFTAB_WORKING_DOUBLE={} -DBRDFTAB_TABLE_DOUBLE={}",
                               working == Precision::float64 ? 1 : 0, table == Precision::float64 ? 1 : 0);
  if (device_.handle.getInfo<CL_DEVICE_SINGLE_FP_CONFIG>() & CL_FP_CORRECTLY_ROUNDED_DIVIDE_SQRT)
    build_options_ += " -cl-fp32-correctly-rounded-divide-sqrt";
  // A cache line; a GPU works on scalars.
  if (directions_width_ == 0) directions_width_ = device_.is_gpu ? 1 : 64 / bytes_of(working);
  context_ = cl::Context(device_.handle);
  queue_ = cl::CommandQueue(context_, device_.handle);
  program_ = build(build_options_);
}

cl::Program Engine::build(const std::string& options) const {
  cl::Program program(context_, std::string(kernel_source));
  try {
    // Without -w PoCL prints how many vectors are wider than those of the processor, which a user can do
    // nothing about.
    program.build({device_.handle}, (options + " -w").c_str());
  } catch (const cl::BuildError& error) {
    std::string log;
    for (const auto& [built_for, text] : error.getBuildLog()) log += text;
    if (const auto shortage = pocl_cache_shortage(); !shortage.empty())
      throw Error(Fault::device, "the kernels do not build on {}: {}", device_.name, shortage);
    throw Error(Fault::device, "the kernels do not build on {} with {}:\n{}", device_.description(), options,
                log);
  }
  return program;
}

cl::Kernel Engine::directions_kernel(const char* name) const {
  if (!directions_())
    directions_ =
        build(fmt::format("{} -DBRDFTAB_DIRECTIONS=1 -DBRDFTAB_WIDTH={}", build_options_, directions_width_));
  return cl::Kernel(directions_, name);
}

cl::Kernel Engine::gradient_kernel(const char* name) const {
  if (!gradients_())
    gradients_ =
        build(fmt::format("{} -DBRDFTAB_GRADIENTS=1 -DBRDFTAB_WIDTH={}", build_options_, directions_width_));
  return cl::Kernel(gradients_, name);
}

cl::Buffer Engine::buffer(std::size_t bytes) const {
  return cl::Buffer(context_, CL_MEM_READ_WRITE, std::max<std::size_t>(bytes, 1));
}

cl::Buffer Engine::upload(std::span<const std::byte> bytes) const {
  cl::Buffer result = buffer(bytes.size());
  if (!bytes.empty()) queue_.enqueueWriteBuffer(result, CL_TRUE, 0, bytes.size(), bytes.data());
  return result;
}

cl::Buffer Engine::upload(std::span<const double> values, Precision precision) const {
  if (precision == Precision::float64) return upload(std::as_bytes(values));
  const std::vector<float> narrow(values.begin(), values.end());
  return upload(std::as_bytes(std::span(narrow)));
}

void Engine::set_number(cl::Kernel& kernel, cl_uint index, Precision precision, double value) {
  if (precision == Precision::float64)
    kernel.setArg(index, value);
  else
    kernel.setArg(index, static_cast<float>(value));
}

void Engine::check_polar_angles(std::span<const double> theta) const {
  for (const double angle : theta)
    if (working_ == Precision::float32 && static_cast<float>(angle) >= 90)
      throw BadInput("theta = {} degrees is 90 in float32 arithmetic: it must stay below 89.999996",
                     shortest(angle));
}

cl::Buffer Engine::upload_polar_angles(std::span<const double> theta) const {
  check_polar_angles(theta);
  return upload(theta);
}

std::vector<double> Engine::download(const cl::Buffer& buffer, std::size_t count) const {
  std::vector<double> values(count);
  if (count == 0) return values;
  if (working_ == Precision::float64) {
    queue_.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(double), values.data());
  } else {
    std::vector<float> narrow(count);
    queue_.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(float), narrow.data());
    std::copy(narrow.begin(), narrow.end(), values.begin());
  }
  return values;
}

std::vector<int> Engine::download_ints(const cl::Buffer& buffer, std::size_t count) const {
  std::vector<int> values(count);
  if (count > 0) queue_.enqueueReadBuffer(buffer, CL_TRUE, 0, count * sizeof(int), values.data());
  return values;
}

void Engine::run(const cl::Kernel& kernel, std::array<std::size_t, 3> size) const {
  const auto [x, y, z] = size;
  const auto allowed = kernel.getWorkGroupInfo<CL_KERNEL_WORK_GROUP_SIZE>(device_.handle);
  const std::size_t longest =
      std::min<std::size_t>({device_.largest_work_group, allowed, device_.is_gpu ? 256u : 4096u});
  const std::size_t groups = (x + longest - 1) / longest;
  const std::size_t group = (x + groups - 1) / groups;
  const std::size_t even = x / group * group;
  queue_.enqueueNDRangeKernel(kernel, {0, 0, 0}, {even, y, z}, {group, 1, 1});
  if (even < x) queue_.enqueueNDRangeKernel(kernel, {x - group, 0, 0}, {group, y, z}, {group, 1, 1});
}

std::size_t Engine::padded_directions(std::size_t count) const {
  const std::size_t together = directions_group(device_) * directions_width_;
  return (count + together - 1) / together * together;
}

void Engine::run_directions(const cl::Kernel& kernel, std::size_t padded) const {
  queue_.enqueueNDRangeKernel(kernel, cl::NullRange, {padded / directions_width_},
                              {directions_group(device_)});
}

void Engine::run_items(const cl::Kernel& kernel, std::array<std::size_t, 3> size, std::size_t first_x) const {
  queue_.enqueueNDRangeKernel(kernel, {first_x, 0, 0}, {size[0], size[1], size[2]},
                              device_.is_gpu ? cl::NullRange : cl::NDRange(1, 1, 1));
}

}  // namespace brdftab

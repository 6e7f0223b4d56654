#include "host/formats/rgl/rgl_content.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

constexpr double pi = std::numbers::pi;

/// Takes the fields of a file, and checks each of them.
class FieldReader {
 public:
  FieldReader(const std::filesystem::path& file, const TensorFields& fields)
      : file_(file.string()), fields_(fields) {}

  /// An extent of 0 asks for two or more.
  const Tensor& floats(const std::string& name, const std::vector<std::uint64_t>& shape) const {
    const auto field = fields_.find(name);
    if (field == fields_.end()) throw BadInput("{}: has no field {}, which an RGL file needs", file_, name);
    const Tensor& tensor = field->second;
    bool fits = !tensor.floats.empty() && tensor.shape.size() == shape.size();
    for (std::size_t k = 0; fits && k < shape.size(); ++k)
      fits = shape[k] == 0 ? tensor.shape[k] >= 2 : tensor.shape[k] == shape[k];
    if (!fits)
      throw BadInput("{}: field {}: is {} of shape [{}]; must be float32 of shape [{}], where 0 is 2 or more",
                     file_, name, tensor.floats.empty() ? "bytes" : "float32", fmt::join(tensor.shape, ", "),
                     fmt::join(shape, ", "));
    if (!std::all_of(tensor.floats.begin(), tensor.floats.end(),
                     [](float value) { return std::isfinite(value); }))
      throw BadInput("{}: field {}: has values that are not finite", file_, name);
    return tensor;
  }

  const Tensor& positive(const std::string& name, const std::vector<std::uint64_t>& shape) const {
    const Tensor& tensor = floats(name, shape);
    if (std::any_of(tensor.floats.begin(), tensor.floats.end(), [](float value) { return value <= 0; }))
      throw BadInput("{}: field {}: must be above 0 everywhere", file_, name);
    return tensor;
  }

  std::vector<float> increasing(const std::string& name) const {
    const auto field = fields_.find(name);
    const std::uint64_t nodes = field == fields_.end() ? 0 : field->second.floats.size();
    const auto values = floats(name, {nodes}).floats;
    for (std::size_t k = 1; k < values.size(); ++k)
      if (!(values[k] > values[k - 1])) throw BadInput("{}: field {}: must increase strictly", file_, name);
    return values;
  }

 private:
  std::string file_;
  const TensorFields& fields_;
};

}  // namespace

double RglPlace::of_theta(double degrees) { return std::sqrt(degrees / 90); }

double RglPlace::theta(double x) { return 90 * x * x; }

double RglPlace::solid_angle(double x) { return 2 * pi * pi * x * std::sin(pi / 2 * x * x); }

SquarePoint RglPlace::of(const SurfaceVector& direction, double phi_0) {
  const double turns = (direction.phi() - phi_0 + 180) / 360;
  return {of_theta(direction.theta()), turns - std::floor(turns)};
}

SurfaceVector RglPlace::direction(SquarePoint place) {
  const double theta = pi / 2 * place.x * place.x, phi = (2 * place.y - 1) * pi;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

TensorFields RglContent::fields() const {
  TensorFields fields;
  fields["jacobian"] = {{1}, {1}, {}};
  fields["phi_i"] = Tensor::of_floats({1}, {0});
  fields["theta_i"] = Tensor::of_floats({theta_i.size()}, theta_i);
  fields["ndf"] = Tensor::of_floats({2, ndf.size() / 2}, ndf);
  fields["sigma"] = Tensor::of_floats({2, sigma.size() / 2}, sigma);
  fields["vndf"] = Tensor::of_floats({1, theta_i.size(), vndf_rows, vndf_columns}, vndf);
  fields["luminance"] = Tensor::of_floats({1, theta_i.size(), samples, samples}, luminance);
  fields[wavelengths_nm.empty() ? "rgb" : "spectra"] =
      Tensor::of_floats({1, theta_i.size(), channels, samples, samples}, spectra);
  if (!wavelengths_nm.empty())
    fields["wavelengths"] = Tensor::of_floats({wavelengths_nm.size()}, wavelengths_nm);
  return fields;
}

RglContent RglContent::from_fields(const std::filesystem::path& file, const TensorFields& fields) {
  const FieldReader reader(file, fields);
  RglContent content;
  content.theta_i = reader.increasing("theta_i");
  if (const auto phi_i = reader.increasing("phi_i"); phi_i.size() != 1)
    throw BadInput("{}: field phi_i: has {} nodes, an anisotropic material; one node can be read",
                   file.string(), phi_i.size());
  if (fields.contains("wavelengths")) content.wavelengths_nm = reader.increasing("wavelengths");
  const std::uint64_t angles = content.theta_i.size();
  content.channels = content.wavelengths_nm.empty() ? 3 : content.wavelengths_nm.size();
  // Rows run along the azimuth. Those of an isotropic surface are equal, and one stands for all.
  for (const auto& [name, table] : {std::pair{"ndf", &content.ndf}, std::pair{"sigma", &content.sigma}})
    *table = reader.positive(name, {2, 0}).floats;
  const Tensor& vndf = reader.floats("vndf", {1, angles, 0, 0});
  content.vndf = vndf.floats;
  content.vndf_rows = vndf.shape[2];
  content.vndf_columns = vndf.shape[3];
  const std::size_t slice = content.vndf_rows * content.vndf_columns;
  for (std::size_t k = 0; k < content.vndf.size(); k += slice) {
    const auto begin = content.vndf.begin() + static_cast<std::ptrdiff_t>(k),
               end = begin + static_cast<std::ptrdiff_t>(slice);
    if (*std::min_element(begin, end) < 0 || *std::max_element(begin, end) == 0)
      throw BadInput("{}: field vndf: must be 0 or more, and above 0 somewhere at each theta_i",
                     file.string());
  }
  const Tensor& luminance = reader.floats("luminance", {1, angles, 0, 0});
  content.luminance = luminance.floats;
  content.samples = luminance.shape[2];
  content.spectra = reader
                        .floats(content.wavelengths_nm.empty() ? "rgb" : "spectra",
                                {1, angles, content.channels, content.samples, content.samples})
                        .floats;
  return content;
}

}  // namespace brdftab

#include "host/pictures/subject.hpp"

#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/sampled_model.hpp"
#include "host/formats/open_table.hpp"
#include "host/formats/read_material.hpp"

namespace brdftab {
namespace {

constexpr double same_angle = 1e-9;  // degrees

std::size_t nearest(std::span<const double> nodes, double angle) {
  const auto at = std::min_element(nodes.begin(), nodes.end(), [&](double a, double b) {
    return std::abs(a - angle) < std::abs(b - angle);
  });
  return static_cast<std::size_t>(at - nodes.begin());
}

}  // namespace

Subject Subject::open(const std::string& file) {
  if (brdftab::is_table(file)) return of_table(file, open_table(file));
  Subject subject;
  subject.file_ = file;
  subject.material_ = read_material(file);
  return subject;
}

Subject Subject::of_table(std::string file, std::unique_ptr<TableReader> reader) {
  Subject subject;
  subject.file_ = std::move(file);
  subject.reader_ = std::move(reader);
  subject.table_ = rebuild(subject.reader_->info(), subject.file_);
  return subject;
}

std::size_t Subject::band(std::optional<double> wavelength_nm) const {
  const auto& bands = material().bands();
  if (!wavelength_nm || !material().has_wavelengths()) return 0;
  std::vector<std::string> known;
  for (std::size_t k = 0; k < bands.size(); ++k) {
    if (std::abs(*bands[k].wavelength_nm - *wavelength_nm) <= 1e-6) return k;
    known.push_back(shortest(*bands[k].wavelength_nm));
  }
  throw BadInput("--wavelength {}: {} has the bands {} nm", shortest(*wavelength_nm), file_,
                 fmt::join(known, ", "));
}

std::vector<std::size_t> Subject::nodes_theta_i(std::span<const double> theta_i) const {
  const auto nodes = table().grid.theta_i.nodes();
  std::vector<std::size_t> indices;
  for (const double angle : theta_i) {
    indices.push_back(nearest(nodes, angle));
    if (std::abs(nodes[indices.back()] - angle) > same_angle)
      throw BadInput("--theta-i {}: is no node of {}; the nearest is {}", shortest(angle), file_,
                     shortest(nodes[indices.back()]));
  }
  return indices;
}

std::vector<double> Subject::usual_theta_i(std::span<const double> wanted) const {
  std::vector<double> result(wanted.begin(), wanted.end());
  if (!is_table()) return result;
  const auto nodes = table().grid.theta_i.nodes();
  for (double& angle : result) angle = nodes[nearest(nodes, angle)];
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

std::vector<double> DrawnModel::of(const Band& band, std::span<const DirectionPair> pairs) const {
  std::vector<double> f;
  f.reserve(pairs.size());
  for (const PolarizedBrdf& value : evaluate(engine_, band, variant(), pairs)) {
    f.push_back(polarization_ == Polarization::s   ? value.s
                : polarization_ == Polarization::p ? value.p
                                                   : value.unpolarized());
    if (!std::isfinite(f.back()))
      throw BadInput(
          "{}: f is not finite at theta_i = {}, theta_s = {}, phi = {} degrees: a lobe is too narrow there",
          subject_.file(), shortest(pairs[f.size() - 1].theta_i),
          shortest(pairs[f.size() - 1].model_theta_s()), shortest(pairs[f.size() - 1].model_phi()));
  }
  return f;
}

std::vector<double> DrawnModel::brdf(std::span<const DirectionPair> pairs) const { return of(band_, pairs); }

std::vector<double> DrawnModel::brdf_of_many(std::span<const DirectionPair> pairs) const {
  if (variant().normalization != Normalization::reciprocal) return brdf(pairs);
  const auto& bands = subject_.material().bands();
  const auto band = std::find_if(bands.begin(), bands.end(),
                                 [&](const Band& b) { return b.wavelength_nm == band_.wavelength_nm; });
  const double theta_i = pairs.front().theta_i;
  Directions directions;
  double last = 0;
  for (const DirectionPair& pair : pairs) {
    directions.add(pair.theta_i, pair.model_theta_s(), pair.model_phi());
    last = std::max(last, pair.model_theta_s());
  }
  const SampledModel sampled(engine_, subject_.material(), {polarization_}, {theta_i, theta_i}, {0, last});
  return sampled.evaluate(directions)[static_cast<std::size_t>(band - bands.begin())];
}

std::vector<double> DrawnModel::brdf(Lobe lobe, std::span<const DirectionPair> pairs) const {
  // N, D and V_m of a lobe do not depend on the amplitudes of the others.
  Band alone = band_;
  if (lobe != Lobe::surface) alone.parameters.sigma_surface = 0;
  if (lobe != Lobe::bulk) alone.parameters.sigma_bulk = 0;
  if (lobe != Lobe::retro) alone.parameters.sigma_retro = 0;
  return of(alone, pairs);
}

}  // namespace brdftab

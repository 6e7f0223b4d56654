#include "host/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "host/error.hpp"
#include "host/numbers.hpp"

namespace brdftab {
namespace {

// Nodes of working memory that no table is too small for.
constexpr std::size_t smallest_room = 1 << 20;

// f is even and periodic in phi; both operations are exact.
double folded_azimuth(double phi_i, double phi_s) { return std::abs(std::remainder(phi_s - phi_i, 360.0)); }

cl_int as_int(std::size_t count) { return static_cast<cl_int>(count); }

template <class Real>
std::optional<std::size_t> first_not_finite(std::span<const std::byte> samples) {
  const auto* values = reinterpret_cast<const Real*>(samples.data());
  const std::size_t count = samples.size() / sizeof(Real);
  const auto* at = std::find_if_not(values, values + count, [](Real f) { return std::isfinite(f); });
  if (at == values + count) return std::nullopt;
  return static_cast<std::size_t>(at - values);
}

}  // namespace

Plan::Plan(const Engine& engine, const Material& material, const Band& band, const Grid& grid)
    : engine_(engine),
      material_(material),
      band_(band),
      grid_(grid),
      kernel_material_(band.parameters, material.switches(), engine.working()),
      gaussian_(material.switches().autocovariance == Autocovariance::gaussian),
      coefficients_(gaussian_ ? 3 : 2),
      integrals_(brdftab::integrals(engine, band, material.switches(), grid.theta_i.nodes())) {
  if (material.switches().normalization == Normalization::reciprocal)
    normalization_s_ = normalizations(engine, band, material.switches(), grid.theta_s.nodes());

  const auto polar_table = [&](const Axis& axis) {
    const cl::Buffer theta = engine_.upload_polar_angles(axis.nodes());
    const cl::Buffer factors = engine_.buffer(axis.size() * polar_factors_reals * bytes_of(engine_.working()));
    cl::Kernel kernel = engine_.kernel("polar_table");
    set_arguments(kernel, theta, factors);
    kernel_material_.set(kernel, 2);
    engine_.run_items(kernel, {axis.size(), 1, 1});
    return factors;
  };
  polar_i_ = polar_table(grid.theta_i);
  polar_s_ = polar_table(grid.theta_s);

  incidence_shadowing_ = engine_.buffer(grid.theta_i.size() * 2 * bytes_of(engine_.table()));
  cl::Kernel kernel = engine_.kernel("incidence_shadowing_table");
  set_arguments(kernel, polar_i_, incidence_shadowing_);
  kernel_material_.set(kernel, 2, false);
  engine_.run_items(kernel, {grid.theta_i.size(), 1, 1});
}

std::vector<int> Plan::fold_azimuths(Range phi_i) {
  const auto phi_s = grid_.phi_s.nodes();
  std::vector<double> all;
  all.reserve(phi_i.size() * phi_s.size());
  for (std::size_t i = phi_i.begin; i < phi_i.end; ++i)
    for (const double s : phi_s) all.push_back(folded_azimuth(grid_.phi_i[i], s));
  azimuths_ = all;
  // One phi_i: rows of phi_s come out in place. More: each distinct azimuth is computed once and spread.
  spread_ = phi_i.size() > 1;
  if (!spread_) return {};
  std::sort(azimuths_.begin(), azimuths_.end());
  azimuths_.erase(std::unique(azimuths_.begin(), azimuths_.end()), azimuths_.end());
  std::vector<int> index(all.size());
  std::transform(all.begin(), all.end(), index.begin(), [&](double phi) {
    return as_int(static_cast<std::size_t>(std::lower_bound(azimuths_.begin(), azimuths_.end(), phi) - azimuths_.begin()));
  });
  return index;
}

void Plan::prepare_azimuths(const Slab& slab) {
  if (azimuths_phi_i_ && azimuths_phi_i_->begin <= slab.phi_i.begin && slab.phi_i.end <= azimuths_phi_i_->end) return;
  // All phi_i at once where their rows take no more room than a slab: uniform grids have few distinct azimuths.
  Range group{0, grid_.phi_i.size()};
  std::vector<int> index;
  const std::size_t room = std::max(slab.nodes(), smallest_room);
  bool whole_axis = !phi_i_by_slab_ && group.size() * grid_.phi_s.size() <= room;
  if (whole_axis) {
    index = fold_azimuths(group);
    whole_axis = azimuths_.size() * slab.theta_i.size() * slab.theta_s.size() <= room;
  }
  if (!whole_axis) {
    phi_i_by_slab_ = true;
    group = slab.phi_i;
    index = fold_azimuths(group);
  }
  if (spread_) azimuth_of_ = engine_.upload(std::span<const int>(index));
  const std::size_t table_bytes = azimuths_.size() * bytes_of(engine_.table());
  azimuth_ = engine_.buffer(azimuths_.size() * azimuth_factors_reals * bytes_of(engine_.working()));
  sin2_half_ = engine_.buffer(table_bytes);
  cos2_half_ = engine_.buffer(table_bytes);
  forward_ = engine_.buffer(table_bytes);
  const cl::Buffer phi = engine_.upload(std::span<const double>(azimuths_));
  cl::Kernel kernel = engine_.kernel("azimuth_table");
  set_arguments(kernel, phi, azimuth_, sin2_half_, cos2_half_, forward_);
  engine_.run_items(kernel, {azimuths_.size(), 1, 1});
  azimuths_phi_i_ = group;
  shadowing_theta_s_.reset();
  rows_of_.reset();
}

void Plan::prepare_shadowing(const Slab& slab) {
  if (shadowing_theta_s_ == slab.theta_s) return;
  scatter_shadowing_ = engine_.buffer(slab.theta_s.size() * azimuths_.size() * bytes_of(engine_.table()));
  cl::Kernel kernel = engine_.kernel("scatter_shadowing_table");
  set_arguments(kernel, polar_s_, azimuth_, as_int(slab.theta_s.begin), as_int(azimuths_.size()), scatter_shadowing_);
  kernel_material_.set(kernel, 5, false);
  engine_.run(kernel, {azimuths_.size(), slab.theta_s.size(), 1});
  shadowing_theta_s_ = slab.theta_s;
}

void Plan::tabulate_pairs(const Slab& slab, Polarization polarization) {
  const std::size_t count = slab.theta_i.size() * slab.theta_s.size();
  const std::size_t bytes = count * 3 * coefficients_ * bytes_of(gaussian_ ? engine_.working() : engine_.table());
  if (bytes > pairs_bytes_) {
    pairs_ = engine_.buffer(bytes);
    alarms_ = engine_.buffer(count * sizeof(cl_int));
    pairs_bytes_ = bytes;
  }
  cl::Kernel kernel = engine_.kernel(gaussian_ ? "gaussian_pairs" : "lorentzian_pairs");
  const Normalizations& scatter = normalization_s_ ? *normalization_s_ : integrals_.normalization;
  set_arguments(kernel, polar_i_, polar_s_, integrals_.normalization.on_device, as_int(grid_.theta_i.size()), scatter.on_device,
                as_int(normalization_s_ ? grid_.theta_s.size() : 0), as_int(slab.theta_i.begin), as_int(slab.theta_s.begin),
                pairs_, alarms_, as_int(static_cast<std::size_t>(polarization)));
  kernel_material_.set(kernel, 11);
  engine_.run_items(kernel, {slab.theta_s.size(), slab.theta_i.size(), 1});
}

void Plan::tabulate_rows(const Slab& slab, const cl::Buffer& rows) {
  const auto shadowing = material_.switches().reflectance_shadowing;
  const cl_int surface_shadowed = shadowing != ReflectanceShadowing::none;
  const cl_int subsurface_shadowed = shadowing == ReflectanceShadowing::all;
  const cl_int first_i = as_int(slab.theta_i.begin);
  cl::Kernel kernel = engine_.kernel(gaussian_ ? "gaussian_samples" : "lorentzian_samples");
  if (gaussian_)
    set_arguments(kernel, pairs_, incidence_shadowing_, scatter_shadowing_, azimuth_, rows, as_int(azimuths_.size()), first_i,
                  surface_shadowed, subsurface_shadowed);
  else
    set_arguments(kernel, pairs_, incidence_shadowing_, scatter_shadowing_, sin2_half_, cos2_half_, forward_, rows,
                  as_int(azimuths_.size()), first_i, surface_shadowed, subsurface_shadowed);
  engine_.run(kernel, {azimuths_.size(), slab.theta_s.size(), slab.theta_i.size()});
}

void Plan::tabulate(const Slab& slab, Polarization polarization, const cl::Buffer& samples) {
  prepare_azimuths(slab);
  prepare_shadowing(slab);
  if (!spread_) {
    tabulate_pairs(slab, polarization);
    tabulate_rows(slab, samples);
    return;
  }
  // Slabs of one theta_i that differ in phi_i share their rows.
  const RowsKey key{slab.theta_i, slab.theta_s, polarization};
  if (rows_of_ != key) {
    tabulate_pairs(slab, polarization);
    const std::size_t bytes = slab.theta_i.size() * slab.theta_s.size() * azimuths_.size() * bytes_of(engine_.table());
    if (bytes > rows_bytes_) {
      rows_ = engine_.buffer(bytes);
      rows_bytes_ = bytes;
    }
    tabulate_rows(slab, rows_);
    rows_of_ = key;
  }
  cl::Kernel spread = engine_.kernel("spread_azimuths");
  set_arguments(spread, rows_, azimuth_of_, samples, as_int(azimuths_.size()), as_int(slab.phi_s),
                as_int(slab.phi_i.begin - azimuths_phi_i_->begin), as_int(slab.phi_i.size()));
  engine_.run(spread, {slab.phi_s, slab.theta_s.size(), slab.theta_i.size() * slab.phi_i.size()});
}

void Plan::refuse(std::size_t i, std::size_t s, const std::string& where, std::string_view fault, int lobes) const {
  std::vector<std::string> widths;
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    if (lobes & (1 << lobe)) {
      const auto& rho = parameter_table[3 + 2 * lobe];
      widths.push_back(fmt::format("{} = {}", rho.name, shortest(band_.parameters.*rho.member)));
    }
  throw BadInput("{}{}: brdf {} at theta_i = {}, theta_s = {}{}: {}, w = {} and n = {} make the lobe too narrow there",
                 material_.name(), band_.wavelength_nm ? fmt::format(", {} nm", shortest(*band_.wavelength_nm)) : "", fault,
                 shortest(grid_.theta_i[i]), shortest(grid_.theta_s[s]), where, fmt::join(widths, ", "),
                 shortest(band_.parameters.w), shortest(band_.parameters.n));
}

void Plan::check(const Slab& slab, std::span<const std::byte> samples) {
  const std::size_t pairs = slab.theta_i.size() * slab.theta_s.size();
  const auto alarms = engine_.download_ints(alarms_, pairs);
  int near_limit = 0;
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    near_limit |= alarms[pair] & 7;
    if (const int lobes = alarms[pair] >> 3)
      refuse(slab.theta_i.begin + pair / slab.theta_s.size(), slab.theta_s.begin + pair % slab.theta_s.size(), " degrees",
             fmt::format("is beyond what {} holds", name_of(engine_.table())), lobes);
  }
  if (near_limit == 0) return;
  const auto at = engine_.table() == Precision::float64 ? first_not_finite<double>(samples) : first_not_finite<float>(samples);
  if (!at) return;
  const std::size_t phi_s = *at % slab.phi_s;
  const std::size_t row = *at / slab.phi_s;
  const std::size_t s = slab.theta_s.begin + row % slab.theta_s.size();
  const std::size_t incidence = row / slab.theta_s.size();
  const std::size_t phi_i = slab.phi_i.begin + incidence % slab.phi_i.size();
  const std::size_t i = slab.theta_i.begin + incidence / slab.phi_i.size();
  refuse(i, s, fmt::format(", phi_i = {}, phi_s = {} degrees", shortest(grid_.phi_i[phi_i]), shortest(grid_.phi_s[phi_s])),
         fmt::format("is not finite in {}", name_of(engine_.table())),
         alarms[(i - slab.theta_i.begin) * slab.theta_s.size() + (s - slab.theta_s.begin)] & 7);
}

}  // namespace brdftab

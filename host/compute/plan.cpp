#include "host/compute/plan.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/compute/on_host/kernels_on_host.hpp"

namespace brdftab {
namespace {

// Numbers of working memory for a slab's strips, for the shadowing of all theta_s and phi_i, and for
// azimuths.
constexpr std::size_t strips_room = 16 << 20;
constexpr std::size_t shadowing_room = 32 << 20;
constexpr std::size_t azimuths_room = 2 << 20;

// f is even and periodic in phi; both operations are exact.
double folded(double phi) { return std::abs(std::remainder(phi, 360.0)); }

// `Range` of kernels/tabulate.cl.
struct KernelRange {
  cl_int first_i, first_phi_i, count_phi_i, first_s, count_s, nodes_phi_s, azimuths;
};

cl_int as_int(std::size_t count) { return static_cast<cl_int>(count); }

template <class Real>
std::optional<std::size_t> first_not_finite(std::span<const std::byte> samples) {
  const auto* values = reinterpret_cast<const Real*>(samples.data());
  const std::size_t count = samples.size() / sizeof(Real);
  const auto* at = std::find_if_not(values, values + count, [](Real f) { return std::isfinite(f); });
  if (at == values + count) return std::nullopt;
  return static_cast<std::size_t>(at - values);
}

// Decimal axes make differences that should be equal differ in their last digits. A float32 table cannot tell
// angles of 9e-15 rad apart; a float64 table takes exact ones only.
std::optional<EvenDifferences> even_differences(const Grid& grid, Precision table) {
  const auto phi_i = grid.phi_i.nodes();
  const auto phi_s = grid.phi_s.nodes();
  if (phi_i.size() < 2 || phi_s.size() < 2) return std::nullopt;
  // Worth it where one row that holds all is shorter than they are.
  const double step = (phi_s.back() - phi_s.front()) / static_cast<double>(phi_s.size() - 1);
  const double longest = (phi_i.back() - phi_i.front()) / step + static_cast<double>(phi_s.size());
  if (!(longest <= 0.75 * static_cast<double>(phi_i.size() * phi_s.size()))) return std::nullopt;
  const double tolerance = table == Precision::float64 ? 0 : 5e-13;
  EvenDifferences even{phi_s.front() - phi_i.back(),
                       (phi_s.back() - phi_s.front()) / static_cast<double>(phi_s.size() - 1),
                       phi_s.size(),
                       {}};
  for (const double phi : phi_i) {
    const double shift = std::nearbyint((phi_i.back() - phi) / even.step);
    even.shift.push_back(static_cast<int>(shift));
    for (std::size_t k = 0; k < phi_s.size(); ++k)
      if (std::abs((phi_s[k] - phi) - (even.first + (shift + static_cast<double>(k)) * even.step)) >
          tolerance)
        return std::nullopt;
  }
  return even;
}

}  // namespace

std::size_t EvenDifferences::nodes() const { return static_cast<std::size_t>(shift.front()) + phi_s; }

double EvenDifferences::at(std::size_t k) const { return folded(first + static_cast<double>(k) * step); }

Plan::Plan(const Engine& engine, const Material& material, const Band& band, const Grid& grid,
           const Integrals& integrals)
    : engine_(engine),
      material_(material),
      band_(band),
      grid_(grid),
      kernel_material_(band.parameters, material.variant(), engine.working()),
      gaussian_(material.variant().autocovariance == Autocovariance::gaussian) {
  engine.check_polar_angles(grid.theta_s.nodes());
  even_ = even_differences(grid, engine.table());
  std::vector<double> n_i;
  for (const auto& lobe : integrals.normalization.value) n_i.insert(n_i.end(), lobe.begin(), lobe.end());
  normalization_i_ = engine.upload(n_i);
  normalization_s_ = material.variant().normalization == Normalization::reciprocal
                         ? normalizations(engine, band, material.variant(), grid.theta_s.nodes()).on_device
                         : engine.upload(std::vector<double>(3 * grid.theta_s.size()));
  const auto polar_tables = engine.working() == Precision::float64 ? kernels_on_host::Double::polar_tables
                                                                   : kernels_on_host::Float::polar_tables;
  const auto incidence = polar_tables(band.parameters, material.variant(), grid.theta_i.nodes());
  polar_i_ = engine.upload(incidence.factors);
  incidence_shadowing_ = engine.upload(incidence.incidence_shadowing, engine.table());
  const auto scatter = polar_tables(band.parameters, material.variant(), grid.theta_s.nodes());
  polar_s_ = engine.upload(scatter.factors);
  samples_kernel_ = gaussian_                      ? "gaussian_samples"
                    : combines(incidence, scatter) ? "lorentzian_samples"
                                                   : "lorentzian_samples_apart";
}

bool Plan::combines(const kernels_on_host::PolarTables& incidence,
                    const kernels_on_host::PolarTables& scatter) const {
  // Both fall with the polar angle.
  const std::size_t i = incidence.angles() - 1;
  const std::size_t s = scatter.angles() - 1;
  const double mean_cosine = 0.5 * (incidence.cosine(i) + scatter.cosine(s));
  const double foreshortening = material_.variant().foreshortening ? mean_cosine * mean_cosine : 1;
  const double narrowing = foreshortening * incidence.v(i) * scatter.v(s);
  const Parameters& p = band_.parameters;
  double range = 1;
  for (const auto& [sigma, rho] :
       {std::pair{p.sigma_surface, p.rho_surface}, std::pair{p.sigma_bulk, p.rho_bulk},
        std::pair{p.sigma_retro, p.rho_retro}})
    if (sigma > 0) range *= 1 + 4 / (rho * rho * narrowing);
  // Their product lies between range^(+-1/2): the numerator of f is then a normal float for f above 1e-26 at
  // its peak.
  constexpr double widest_range = 1e24;
  return range <= widest_range;
}

void Plan::prepare_azimuths(const Slab& slab) {
  if (azimuths_phi_i_ && azimuths_phi_i_->begin <= slab.phi_i.begin && slab.phi_i.end <= azimuths_phi_i_->end)
    return;
  const auto phi_s = grid_.phi_s.nodes();
  Range group{0, grid_.phi_i.size()};
  std::vector<double> azimuths;
  std::vector<int> rows;
  if (even_) {
    for (std::size_t k = 0; k < even_->nodes(); ++k) azimuths.push_back(even_->at(k));
    rows = even_->shift;
  } else {
    const std::size_t all = group.size() * phi_s.size();
    if (all > azimuths_room || 2 * slab.theta_s.size() * all > shadowing_room) group = slab.phi_i;
    for (std::size_t i = group.begin; i < group.end; ++i) {
      rows.push_back(as_int(azimuths.size()));
      for (const double phi : phi_s) azimuths.push_back(folded(phi - grid_.phi_i[i]));
    }
  }
  const auto tables = engine_.working() == Precision::float64
                          ? kernels_on_host::Double::azimuth_tables(azimuths)
                          : kernels_on_host::Float::azimuth_tables(azimuths);
  azimuth_ = engine_.upload(tables.factors);
  const Precision lobes = gaussian_ ? engine_.working() : engine_.table();
  sin2_half_ = engine_.upload(tables.sin2_half, lobes);
  cos2_half_ = engine_.upload(tables.cos2_half, lobes);
  rows_ = engine_.upload(std::span<const int>(rows));
  azimuths_ = azimuths.size();
  azimuths_phi_i_ = group;
  shadowing_theta_s_.reset();
}

void Plan::prepare_shadowing(const Slab& slab) {
  if (shadowing_theta_s_ && shadowing_theta_s_->begin <= slab.theta_s.begin &&
      slab.theta_s.end <= shadowing_theta_s_->end)
    return;
  Range theta_s{0, grid_.theta_s.size()};
  if (2 * theta_s.size() * azimuths_ > shadowing_room) theta_s = slab.theta_s;
  scatter_shadowing_ = engine_.buffer(2 * theta_s.size() * azimuths_ * bytes_of(engine_.table()));
  cl::Kernel kernel = engine_.kernel("scatter_shadowing_table");
  set_arguments(kernel, polar_s_, as_int(grid_.theta_s.size()), azimuth_, as_int(theta_s.begin),
                as_int(azimuths_), scatter_shadowing_);
  kernel_material_.set(kernel, 6);
  engine_.run(kernel, {azimuths_, theta_s.size(), 1});
  shadowing_theta_s_ = theta_s;
}

bool Plan::shares_strips(const Slab& slab) const {
  // Slabs that cut theta_s would take turns with a strip.
  return even_ && slab.theta_s.size() == grid_.theta_s.size() &&
         even_->nodes() * slab.theta_i.size() * slab.theta_s.size() <= strips_room;
}

void Plan::tabulate_pairs(const Slab& slab, Polarization polarization) {
  const std::size_t count = slab.theta_i.size() * slab.theta_s.size();
  const std::size_t bytes = count * 9 * bytes_of(gaussian_ ? engine_.working() : engine_.table());
  if (bytes > pairs_bytes_) {
    pairs_ = engine_.buffer(bytes);
    alarms_ = engine_.buffer(count * sizeof(cl_int));
    pairs_bytes_ = bytes;
  }
  cl::Kernel kernel = engine_.kernel(gaussian_ ? "gaussian_pairs" : "lorentzian_pairs");
  set_arguments(kernel, polar_i_, polar_s_, normalization_i_, as_int(grid_.theta_i.size()), normalization_s_,
                as_int(grid_.theta_s.size()), as_int(slab.theta_i.begin), as_int(slab.theta_s.begin),
                as_int(slab.theta_i.size()), as_int(slab.theta_s.size()), pairs_, alarms_);
  engine_.set_number(kernel, 12, engine_.working(),
                     polarization == Polarization::unpolarized ? 0.5 : polarization == Polarization::s);
  engine_.set_number(kernel, 13, engine_.working(),
                     polarization == Polarization::unpolarized ? 0.5 : polarization == Polarization::p);
  kernel_material_.set(kernel, 14);
  engine_.run(kernel, {slab.theta_s.size(), slab.theta_i.size(), 1});
}

void Plan::tabulate_rows(const Slab& slab, Range phi_i, std::size_t nodes_phi_s, const cl::Buffer& rows,
                         const cl::Buffer& samples) {
  const KernelRange range{.first_i = as_int(slab.theta_i.begin),
                          .first_phi_i = as_int(phi_i.begin),
                          .count_phi_i = as_int(phi_i.size()),
                          .first_s = as_int(slab.theta_s.begin - shadowing_theta_s_->begin),
                          .count_s = as_int(shadowing_theta_s_->size()),
                          .nodes_phi_s = as_int(nodes_phi_s),
                          .azimuths = as_int(azimuths_)};
  cl::Kernel kernel = engine_.kernel(samples_kernel_);
  set_arguments(kernel, pairs_, incidence_shadowing_, scatter_shadowing_, sin2_half_, cos2_half_, samples,
                rows, range);
  const bool subsurface_shadowed = material_.variant().reflectance_shadowing != ReflectanceShadowing::surface;
  engine_.set_number(kernel, 8, engine_.table(), subsurface_shadowed);
  engine_.run(kernel, {nodes_phi_s, slab.theta_i.size() * phi_i.size(), slab.theta_s.size()});
}

void Plan::tabulate(const Slab& slab, Polarization polarization, const cl::Buffer& samples) {
  prepare_azimuths(slab);
  prepare_shadowing(slab);
  const std::size_t first_phi_i = slab.phi_i.begin - azimuths_phi_i_->begin;
  if (!shares_strips(slab)) {
    tabulate_pairs(slab, polarization);
    tabulate_rows(slab, {first_phi_i, first_phi_i + slab.phi_i.size()}, slab.phi_s, rows_, samples);
    return;
  }
  // Slabs of one theta_i that differ in phi_i share their strips.
  const StripsKey key{slab.theta_i, polarization};
  if (strips_of_ != key) {
    tabulate_pairs(slab, polarization);
    const std::size_t bytes =
        slab.theta_i.size() * slab.theta_s.size() * azimuths_ * bytes_of(engine_.table());
    if (bytes > strips_bytes_) {
      strips_ = engine_.buffer(bytes);
      strips_bytes_ = bytes;
    }
    constexpr int whole = 0;
    tabulate_rows(slab, {0, 1}, azimuths_, engine_.upload(std::span(&whole, 1)), strips_);
    strips_of_ = key;
  }
  cl::Kernel rows = engine_.kernel("shifted_rows");
  set_arguments(rows, strips_, rows_, samples, as_int(azimuths_), as_int(slab.phi_s), as_int(first_phi_i),
                as_int(slab.phi_i.size()));
  engine_.run(rows, {slab.phi_s, slab.theta_s.size(), slab.theta_i.size() * slab.phi_i.size()});
}

void Plan::refuse(std::size_t i, std::size_t s, const std::string& where, std::string_view fault,
                  int lobes) const {
  std::vector<std::string> widths;
  for (std::size_t lobe = 0; lobe < 3; ++lobe)
    if (lobes & (1 << lobe)) {
      const auto& rho = parameter_table[3 + 2 * lobe];
      widths.push_back(fmt::format("{} = {}", rho.name, shortest(band_.parameters.*rho.member)));
    }
  throw BadInput(
      "{}{}: brdf {} at theta_i = {}, theta_s = {}{}: {}, w = {} and n = {} make the lobe too narrow there",
      material_.name(), band_.wavelength_nm ? fmt::format(", {} nm", shortest(*band_.wavelength_nm)) : "",
      fault, shortest(grid_.theta_i[i]), shortest(grid_.theta_s[s]), where, fmt::join(widths, ", "),
      shortest(band_.parameters.w), shortest(band_.parameters.n));
}

void Plan::check(const Slab& slab, std::span<const std::byte> samples) {
  const std::size_t pairs = slab.theta_i.size() * slab.theta_s.size();
  const auto alarms = engine_.download_ints(alarms_, pairs);
  int near_limit = 0;
  for (std::size_t pair = 0; pair < pairs; ++pair) {
    near_limit |= alarms[pair] & 7;
    if (const int lobes = alarms[pair] >> 3)
      refuse(slab.theta_i.begin + pair / slab.theta_s.size(), slab.theta_s.begin + pair % slab.theta_s.size(),
             " degrees", fmt::format("is beyond what {} holds", name_of(engine_.table())), lobes);
  }
  if (near_limit == 0) return;
  const auto at = engine_.table() == Precision::float64 ? first_not_finite<double>(samples)
                                                        : first_not_finite<float>(samples);
  if (!at) return;
  const std::size_t phi_s = *at % slab.phi_s;
  const std::size_t row = *at / slab.phi_s;
  const std::size_t s = slab.theta_s.begin + row % slab.theta_s.size();
  const std::size_t incidence = row / slab.theta_s.size();
  const std::size_t phi_i = slab.phi_i.begin + incidence % slab.phi_i.size();
  const std::size_t i = slab.theta_i.begin + incidence / slab.phi_i.size();
  refuse(i, s,
         fmt::format(", phi_i = {}, phi_s = {} degrees", shortest(grid_.phi_i[phi_i]),
                     shortest(grid_.phi_s[phi_s])),
         fmt::format("is not finite in {}", name_of(engine_.table())),
         alarms[(i - slab.theta_i.begin) * slab.theta_s.size() + (s - slab.theta_s.begin)] & 7);
}

}  // namespace brdftab

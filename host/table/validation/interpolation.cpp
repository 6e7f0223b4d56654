#include "host/table/validation/interpolation.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <set>

#include "host/base/statistics.hpp"
#include "host/compute/evaluate.hpp"
#include "host/table/validation/spot_check.hpp"

namespace brdftab {
namespace {

constexpr std::size_t most_incidences = 24;
constexpr std::size_t most_slices = 48;

using Index = std::array<std::size_t, 4>;

std::size_t cells_of(std::size_t nodes) { return std::max<std::size_t>(nodes - 1, 1); }

const Axis& axis_of(const Grid& grid, std::size_t k) {
  return k == 0 ? grid.theta_i : k == 1 ? grid.phi_i : k == 2 ? grid.theta_s : grid.phi_s;
}

double middle(const Axis& axis, std::size_t k) {
  return axis.size() == 1 ? axis[0] : 0.5 * (axis[k] + axis[k + 1]);
}

// Errors of one kind of point.
class Collector {
 public:
  void add(const InterpolationPoint& point, double scale) {
    const double error = std::abs(point.interpolated - point.model) / scale;
    errors_.push_back(error);
    if (!(error <= result_.maximum) || errors_.size() == 1) {
      result_.maximum = error;
      result_.worst = point;
    }
  }
  InterpolationError take() {
    set_percentiles(result_, errors_);
    return result_;
  }

 private:
  InterpolationError result_;
  std::vector<double> errors_;
};

struct Collectors {
  Collector linear, logarithmic;
  InterpolationKind take() { return {linear.take(), logarithmic.take()}; }
};

// The slices round one cell of (theta_i, phi_i), all their nodes.
class CellSlices {
 public:
  CellSlices(TableReader& reader, const StoredTable& table, Polarization polarization, std::size_t band,
             std::size_t i, std::size_t p)
      : grid_(table.grid), i_(i), p_(p) {
    const Slab box{{i, std::min(i + 2, grid_.theta_i.size())},
                   {p, std::min(p + 2, grid_.phi_i.size())},
                   {0, grid_.theta_s.size()},
                   grid_.phi_s.size()};
    across_ = box.phi_i.size();
    samples_.resize(box.nodes());
    reader.read(polarization, band, box, samples_);
    const std::size_t half = samples_.size() / box.theta_i.size();
    peak_ = INFINITY;
    for (std::size_t k = 0; k < samples_.size(); k += half)
      peak_ = std::min(peak_, *std::max_element(samples_.begin() + static_cast<std::ptrdiff_t>(k),
                                                samples_.begin() + static_cast<std::ptrdiff_t>(k + half)));
  }

  // The lower of the largest samples at the two theta_i.
  double peak() const { return peak_; }

  double at(const Index& index) const {
    const std::size_t slice = (index[0] - i_) * across_ + (index[1] - p_);
    return samples_[(slice * grid_.theta_s.size() + index[2]) * grid_.phi_s.size() + index[3]];
  }

  // Half way along the given axes from a cell's lower corner: the mean of the corners, and of their
  // logarithms.
  std::pair<double, std::optional<double>> half_way(const Index& corner,
                                                    const std::array<bool, 4>& along) const {
    double sum = 0, logarithms = 0;
    int corners = 0;
    for (unsigned bits = 0; bits < 16; ++bits) {
      Index index = corner;
      bool wanted = true;
      for (std::size_t k = 0; k < 4; ++k)
        if (bits >> k & 1) {
          wanted = wanted && along[k];
          ++index[k];
        }
      if (!wanted) continue;
      const double value = at(index);
      sum += value;
      logarithms += value > 0 ? std::log(value) : NAN;
      ++corners;
    }
    const double mean_logarithm = logarithms / corners;
    return {sum / corners,
            std::isfinite(mean_logarithm) ? std::optional(std::exp(mean_logarithm)) : std::nullopt};
  }

 private:
  const Grid& grid_;
  std::size_t i_, p_, across_ = 1;
  std::vector<double> samples_;
  double peak_ = 0;
};

}  // namespace

void set_percentiles(InterpolationError& error, std::vector<double>& errors) {
  error.points = errors.size();
  if (errors.empty()) return;
  error.percentile_95 = percentile(errors, 95);
  error.median = median(errors);
}

InterpolationErrors interpolation_errors(const Engine& engine, TableReader& reader, const StoredTable& table,
                                         double floor, std::size_t most_points) {
  const Grid& grid = table.grid;
  std::array<bool, 4> has_cells{};
  Index cells{};
  for (std::size_t k = 0; k < 4; ++k) {
    cells[k] = cells_of(axis_of(grid, k).size());
    has_cells[k] = axis_of(grid, k).size() > 1;
  }
  InterpolationErrors result;
  result.floor = floor;
  result.cells = cells[0] * cells[1] * cells[2] * cells[3];
  std::array<Collectors, 5> collectors;  // along each axis, and the centre

  std::mt19937_64 random(20080103);
  std::set<std::pair<std::size_t, std::size_t>> incidences;
  const auto theta_i = spread_indices(cells[0], most_incidences);
  if (theta_i.size() * cells[1] <= most_slices) {
    for (const auto i : theta_i)
      for (std::size_t p = 0; p < cells[1]; ++p) incidences.emplace(i, p);
  } else {
    for (std::size_t k = 0; k < most_slices; ++k)
      incidences.emplace(theta_i[k % theta_i.size()], random() % cells[1]);
  }
  const std::size_t kinds = table.material.bands().size() * table.polarizations.size();
  const std::size_t in_slice = cells[2] * cells[3];
  const std::size_t wanted = std::max<std::size_t>(most_points / (incidences.size() * kinds), 100);

  for (std::size_t band = 0; band < table.material.bands().size(); ++band)
    for (const Polarization polarization : table.polarizations)
      for (const auto& [i, p] : incidences) {
        engine.watch().stop_if_asked();
        const CellSlices slices(reader, table, polarization, band, i, p);
        std::vector<std::size_t> chosen(std::min(in_slice, wanted));
        if (in_slice <= wanted)
          std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        else
          for (auto& cell : chosen) cell = random() % in_slice;
        for (std::size_t kind = 0; kind < 5; ++kind) {
          if (kind < 4 && !has_cells[kind]) continue;
          std::array<bool, 4> along{};
          for (std::size_t k = 0; k < 4; ++k) along[k] = has_cells[k] && (kind == 4 || kind == k);
          std::vector<DirectionPair> pairs;
          std::vector<Index> corners;
          for (const std::size_t cell : chosen) {
            const Index corner{i, p, cell / cells[3], cell % cells[3]};
            std::array<double, 4> angle{};
            for (std::size_t k = 0; k < 4; ++k)
              angle[k] = along[k] ? middle(axis_of(grid, k), corner[k]) : axis_of(grid, k)[corner[k]];
            pairs.push_back({angle[0], angle[2], angle[3] - angle[1], 0});
            corners.push_back(corner);
          }
          const auto f = evaluate(engine, table.material.bands()[band], table.material.variant(), pairs);
          for (std::size_t k = 0; k < f.size(); ++k) {
            const double model = polarization == Polarization::s   ? f[k].s
                                 : polarization == Polarization::p ? f[k].p
                                                                   : f[k].unpolarized();
            const double scale = std::max(model, floor * slices.peak());
            if (scale < smallest_compared) continue;
            const auto [mean, geometric] = slices.half_way(corners[k], along);
            const double phi_i = along[1] ? middle(grid.phi_i, p) : grid.phi_i[p];
            InterpolationPoint point{{pairs[k].theta_i, phi_i, pairs[k].theta_s, pairs[k].phi + phi_i},
                                     table.material.bands()[band].wavelength_nm,
                                     polarization,
                                     mean,
                                     model};
            collectors[kind].linear.add(point, scale);
            if (!geometric) continue;
            point.interpolated = *geometric;
            collectors[kind].logarithmic.add(point, scale);
          }
        }
      }
  for (std::size_t k = 0; k < 4; ++k) result.along[k] = collectors[k].take();
  result.centre = collectors[4].take();
  return result;
}

}  // namespace brdftab

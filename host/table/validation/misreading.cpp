#include "host/table/validation/misreading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "host/base/angle.hpp"
#include "host/table/validation/spot_check.hpp"

namespace brdftab {
namespace {

using Index = std::array<std::size_t, 4>;
using Angles = std::array<double, 4>;  // degrees, in the order of the axes

constexpr std::size_t incidences = 4;
constexpr std::size_t nodes_per_incidence = 24;
// A mistake explains the samples if this share of them is right under it; others may have been changed
// besides.
constexpr double explained = 0.9;

struct Sample {
  Index index;
  double value;
};

// The angles that a sample would have under a mistake.
struct Mistake {
  std::string words;
  std::function<Angles(const Index&)> angles;
};

Angles angles_at(const Grid& grid, const Index& index) {
  return {grid.theta_i[index[0]], grid.phi_i[index[1]], grid.theta_s[index[2]], grid.phi_s[index[3]]};
}

std::vector<Mistake> mistakes(const Grid& grid) {
  const Index shape{grid.theta_i.size(), grid.phi_i.size(), grid.theta_s.size(), grid.phi_s.size()};
  std::vector<Mistake> list;
  for (int axes = 1; axes < 16; ++axes) {
    std::vector<std::string_view> names;
    for (std::size_t k = 0; k < 4; ++k)
      if (axes >> k & 1) names.push_back(axis_table[k].name);
    list.push_back({fmt::format("{} {} in radians, though the table says degrees", fmt::join(names, ", "),
                                names.size() > 1 ? "are" : "is"),
                    [&grid, axes](const Index& index) {
                      Angles angles = angles_at(grid, index);
                      for (std::size_t k = 0; k < 4; ++k)
                        if (axes >> k & 1) angles[k] *= degrees_per_radian;
                      return angles;
                    }});
  }
  for (std::size_t a = 0; a < 4; ++a)
    for (std::size_t b = a + 1; b < 4; ++b) {
      if (shape[a] == 1 || shape[b] == 1) continue;  // no change, or the same as exchanging two others
      list.push_back({fmt::format("the axes {} and {} are swapped", axis_table[a].name, axis_table[b].name),
                      [&grid, shape, a, b](const Index& index) {
                        // The samples' order with the two axes exchanged, whatever their lengths.
                        std::size_t flat = 0;
                        for (std::size_t k = 0; k < 4; ++k) flat = flat * shape[k] + index[k];
                        Index order{0, 1, 2, 3};
                        std::swap(order[a], order[b]);
                        Index true_index{};
                        for (std::size_t k = 4; k-- > 0;) {
                          true_index[order[k]] = flat % shape[order[k]];
                          flat /= shape[order[k]];
                        }
                        return angles_at(grid, true_index);
                      }});
    }
  for (std::size_t a = 0; a < 4; ++a)
    if (shape[a] > 1)
      list.push_back(
          {fmt::format("the axis {} is reversed", axis_table[a].name), [&grid, shape, a](Index index) {
             index[a] = shape[a] - 1 - index[a];
             return angles_at(grid, index);
           }});
  list.push_back({"azimuth is counted from the backward side", [&grid](const Index& index) {
                    Angles angles = angles_at(grid, index);
                    angles[3] += 180;
                    return angles;
                  }});
  return list;
}

bool explains(const Mistake& mistake, const reference::Model& model, Polarization polarization,
              const std::vector<Sample>& samples, double tolerance) {
  std::size_t right = 0, wrong = 0;
  const auto allowed_wrong = static_cast<std::size_t>((1 - explained) * static_cast<double>(samples.size()));
  for (const Sample& sample : samples) {
    const Angles angles = mistake.angles(sample.index);
    if (!(angles[0] < 90 && angles[2] < 90)) return false;
    const double expected = brdf_at(model, angles[0], angles[2], angles[3] - angles[1], polarization);
    const bool same = std::abs(expected) < smallest_compared
                          ? std::abs(sample.value) < smallest_compared
                          : std::abs(sample.value / expected - 1) <= tolerance;
    ++(same ? right : wrong);
    if (wrong > allowed_wrong) return false;
  }
  return right > 0;
}

}  // namespace

std::string find_misreading(const std::vector<reference::Model>& models, TableReader& reader,
                            const StoredTable& table, double tolerance) {
  std::mt19937_64 random(20080102);
  const Grid& grid = table.grid;
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  std::vector<Sample> samples;
  std::vector<double> row(grid.phi_s.size());
  for (std::size_t k = 0; k < incidences * nodes_per_incidence; ++k) {
    // Few theta_i, since each costs an integral.
    const std::size_t i =
        (k % incidences) * (grid.theta_i.size() - 1) / std::max<std::size_t>(incidences - 1, 1);
    const Index index{i, below(grid.phi_i.size()), below(grid.theta_s.size()), below(grid.phi_s.size())};
    reader.read(
        table.polarizations.front(), 0,
        {{index[0], index[0] + 1}, {index[1], index[1] + 1}, {index[2], index[2] + 1}, grid.phi_s.size()},
        row);
    samples.push_back({index, row[index[3]]});
  }
  // Axes in radians need no more than what other mistakes do: they are tried first and named alone.
  for (const Mistake& mistake : mistakes(grid))
    if (explains(mistake, models.front(), table.polarizations.front(), samples, tolerance))
      return mistake.words;
  return {};
}

}  // namespace brdftab

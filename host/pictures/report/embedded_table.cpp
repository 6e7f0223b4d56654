#include "host/pictures/report/embedded_table.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <bit>

#include "host/base/numbers.hpp"
#include "host/compute/slab.hpp"
#include "host/model/measurement/measured_light.hpp"
#include "host/pictures/drawing/svg.hpp"
#include "host/pictures/hemisphere_figure.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little, "pages hold little-endian samples");

std::vector<double> chosen(const Axis& axis, const std::vector<std::size_t>& indices) {
  std::vector<double> nodes;
  for (const std::size_t k : indices) nodes.push_back(axis[k]);
  return nodes;
}

// Appends the samples of some nodes at one theta_i. Rows that lie beside each other are read at once.
void read_hemisphere(const Subject& table, std::size_t theta_i, std::size_t band, Polarization polarization,
                     const NodeSubset& nodes, std::vector<float>& samples) {
  const std::size_t columns = table.table().grid.phi_s.size();
  std::vector<double> rows;
  for (std::size_t k = 0; k < nodes.theta_s.size();) {
    std::size_t end = k + 1;
    while (end < nodes.theta_s.size() && nodes.theta_s[end] == nodes.theta_s[end - 1] + 1) ++end;
    const Slab box{{theta_i, theta_i + 1}, {0, 1}, {nodes.theta_s[k], nodes.theta_s[end - 1] + 1}, columns};
    rows.resize(box.nodes());
    table.reader().read(polarization, band, box, rows);
    for (std::size_t row = 0; row < end - k; ++row)
      for (const std::size_t column : nodes.phi_s)
        samples.push_back(static_cast<float>(rows[row * columns + column]));
    k = end;
  }
}

std::string set_name(const Subject& table, std::size_t band, Polarization polarization) {
  std::string name(light_word(share_s(polarization)));
  if (table.material().has_wavelengths())
    name += fmt::format(", {} nm", shortest(*table.material().bands()[band].wavelength_nm));
  return name;
}

}  // namespace

NodeSubset spread_nodes(const Grid& grid, std::size_t most) {
  std::array<std::size_t, 3> counts{grid.theta_i.size(), grid.theta_s.size(), grid.phi_s.size()};
  constexpr std::array<double, 3> weights{1, 1, 0.5};
  while (counts[0] * counts[1] * counts[2] > most) {
    std::size_t longest = 0;
    for (std::size_t k = 1; k < 3; ++k)
      if (weights[k] * static_cast<double>(counts[k]) >
          weights[longest] * static_cast<double>(counts[longest]))
        longest = k;
    if (counts[longest] <= 2) break;
    counts[longest] = std::max<std::size_t>(counts[longest] * 15 / 16, 2);
  }
  return {spread_indices(grid.theta_i.size(), counts[0]), spread_indices(grid.theta_s.size(), counts[1]),
          spread_indices(grid.phi_s.size(), counts[2])};
}

Grid subset_grid(const Grid& grid, const NodeSubset& nodes) {
  return {Axis(AxisKind::theta_i, chosen(grid.theta_i, nodes.theta_i)),
          Axis(AxisKind::phi_i, {grid.phi_i[0]}),
          Axis(AxisKind::theta_s, chosen(grid.theta_s, nodes.theta_s)),
          Axis(AxisKind::phi_s, chosen(grid.phi_s, nodes.phi_s))};
}

EmbeddedTable embed(const Subject& table, std::size_t most, const Watch& watch) {
  const Grid& grid = table.table().grid;
  const auto& polarizations = table.table().polarizations;
  const std::size_t bands = table.material().bands().size();
  EmbeddedTable result{
      .nodes = spread_nodes(grid, std::max<std::size_t>(most / (bands * polarizations.size()), 8)),
      .whole = false,
      .scale = {},
      .json = {},
      .float32 = {}};
  const NodeSubset& nodes = result.nodes;
  result.whole = nodes.size() == grid.theta_i.size() * grid.theta_s.size() * grid.phi_s.size();
  std::vector<float> samples;
  std::vector<std::string> names;
  for (std::size_t band = 0; band < bands; ++band)
    for (const Polarization polarization : polarizations) {
      names.push_back(set_name(table, band, polarization));
      for (const std::size_t theta_i : nodes.theta_i) {
        watch.stop_if_asked();
        read_hemisphere(table, theta_i, band, polarization, nodes, samples);
      }
    }
  std::vector<double> positive;
  std::copy_if(samples.begin(), samples.end(), std::back_inserter(positive), [](float f) { return f > 0; });
  result.scale = colour_axis("", std::move(positive));
  std::vector<double> phi = chosen(grid.phi_s, nodes.phi_s);
  for (double& angle : phi) angle -= grid.phi_i[0];
  result.json = nlohmann::json{
      {"theta_i", chosen(grid.theta_i, nodes.theta_i)},
      {"theta_s", chosen(grid.theta_s, nodes.theta_s)},
      {"phi", phi},
      {"sets",
       names}}.dump();
  result.float32 = drawing::base64(std::as_bytes(std::span<const float>(samples)));
  return result;
}

}  // namespace brdftab

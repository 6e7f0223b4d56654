// Maps of f over the hemisphere of scatter directions.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "host/base/error.hpp"
#include "host/pictures/hemisphere_figure.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/plot.hpp"
#include "host/pictures/table_slice.hpp"

namespace brdftab {
namespace {

constexpr double shown_incidences[] = {0, 30, 60, 80};  // degrees

// The maps of one subject, one for each theta_i: a table shows its own samples, a material the model.
std::vector<HemisphereMap> maps_of(const Subject& subject, const PlotOptions& options,
                                   Polarization polarization, const LazyEngine& engine) {
  const std::size_t band = subject.band(options.wavelength_nm);
  const auto theta_i = options.theta_i ? *options.theta_i : subject.usual_theta_i(shown_incidences);
  std::vector<HemisphereMap> maps;
  for (const double angle : theta_i)
    maps.push_back({fmt::format("θ_i = {}", incidence_label(angle)), angle, {}});
  if (subject.is_table()) {
    if (!has_hemispheres(subject.table().grid))
      throw BadInput("{}: its azimuths leave gaps above 90 degrees: there is no hemisphere to draw",
                     subject.file());
    const auto nodes = subject.nodes_theta_i(theta_i);
    for (std::size_t k = 0; k < maps.size(); ++k)
      maps[k].values = TableSlice::read(subject, nodes[k], band, polarization).at_pixels();
  } else {
    const DrawnModel model(engine(), subject, band, polarization);
    for (HemisphereMap& map : maps)
      map.values = HemisphereFigure::pixels().values(
          map.theta_i, [&](std::span<const DirectionPair> pairs) { return model.brdf_of_many(pairs); });
  }
  return maps;
}

// One subject's maps fill two rows at most, or three rows of three; each of several subjects has its own row.
std::size_t columns_for(std::size_t maps, bool has_own_row) {
  if (has_own_row) return maps;
  return maps <= 4 ? 4 : maps == 9 ? 3 : (maps + 1) / 2;
}

}  // namespace

std::string hemisphere_plot(std::span<const Subject> subjects, const PlotOptions& options,
                            const LazyEngine& engine) {
  const Polarization polarization = drawn_polarization(subjects, options);
  HemisphereFigure figure{.title = picture_title(subjects, "BRDF over the hemisphere"),
                          .subtitle = light_text(subjects[0], options, polarization),
                          .footnote = "",
                          .scale = {},
                          .columns = 0,
                          .maps = {}};
  const auto labels = subject_labels(subjects);
  std::vector<double> positive;
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    auto maps = maps_of(subjects[k], options, polarization, engine);
    if (subjects.size() > 1) maps.front().heading = labels[k];
    figure.columns = std::max(figure.columns, columns_for(maps.size(), subjects.size() > 1));
    figure.footnote = subjects[k].is_table() ? "samples of the table, linear in ln f between its nodes" : "";
    for (HemisphereMap& map : maps) {
      std::copy_if(map.values.begin(), map.values.end(), std::back_inserter(positive),
                   [](double f) { return f > 0; });
      figure.maps.push_back(std::move(map));
    }
  }
  figure.scale = colour_axis(brdf_axis_label, std::move(positive));
  return figure.svg();
}

}  // namespace brdftab

// Maps of f over the hemisphere, and of the ratio of two.
#include <algorithm>
#include <cmath>

#include "host/base/error.hpp"
#include "host/base/numbers.hpp"
#include "host/pictures/hemisphere_figure.hpp"
#include "host/pictures/in_plane.hpp"
#include "host/pictures/plot.hpp"
#include "host/pictures/table_slice.hpp"

namespace brdftab {
namespace {

constexpr double shown_incidences[] = {0, 30, 60, 80};

std::vector<double> incidences(const Subject& subject, const PlotOptions& options) {
  return options.theta_i ? *options.theta_i : subject.usual_theta_i(shown_incidences);
}

}  // namespace

std::string hemisphere_plot(std::span<const Subject> subjects, const PlotOptions& options,
                            const LazyEngine& engine) {
  const Polarization polarization = drawn_polarization(subjects, options);
  HemisphereFigure figure{.title = picture_title(subjects, "BRDF over the hemisphere"),
                          .subtitle = light_text(subjects[0], options, polarization),
                          .footnote = "",
                          .scale = {},
                          .maps = {}};
  const auto labels = subject_labels(subjects);
  for (std::size_t k = 0; k < subjects.size(); ++k) {
    const Subject& subject = subjects[k];
    const std::size_t band = subject.band(options.wavelength_nm);
    const auto theta_i = incidences(subject, options);
    if (subject.is_table()) {
      if (!has_hemispheres(subject.table().grid))
        throw BadInput("{}: its azimuths leave gaps above 90 degrees: there is no hemisphere to draw",
                       subject.file());
      const auto nodes = subject.nodes_theta_i(theta_i);
      for (std::size_t i = 0; i < theta_i.size(); ++i) {
        const TableSlice slice = TableSlice::read(subject, nodes[i], band, polarization);
        figure.maps.push_back({"", theta_i[i], slice.at_pixels()});
      }
    } else {
      const DrawnModel model(engine(), subject, band, polarization);
      for (const double angle : theta_i)
        figure.maps.push_back(
            {"", angle,
             HemisphereFigure::pixels().values(
                 angle, [&](std::span<const DirectionPair> pairs) { return model.brdf_of_many(pairs); }),
             std::nullopt});
    }
    for (std::size_t i = 0; i < theta_i.size(); ++i) {
      auto& title = figure.maps[figure.maps.size() - theta_i.size() + i].title;
      title = fmt::format("θ_i = {}", incidence_label(theta_i[i]));
    }
    if (subjects.size() > 1) figure.maps[figure.maps.size() - theta_i.size()].heading = labels[k];
    const std::size_t count = theta_i.size();
    figure.columns = std::max(k > 0 ? figure.columns : 0, subjects.size() > 1 ? count
                                                          : count <= 4        ? 4
                                                          : count == 9        ? 3
                                                                              : (count + 1) / 2);
    figure.footnote = subject.is_table() ? "samples of the table, linear in ln f between its nodes" : "";
  }
  std::vector<double> positive;
  for (const auto& map : figure.maps)
    std::copy_if(map.values.begin(), map.values.end(), std::back_inserter(positive),
                 [](double f) { return f > 0; });
  figure.scale = colour_axis(brdf_axis_label, std::move(positive));
  return figure.svg();
}

}  // namespace brdftab

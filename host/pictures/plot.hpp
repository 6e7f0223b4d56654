// The pictures of a material or a table, each as the text of an SVG file.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "host/model/measurement/measurement.hpp"
#include "host/pictures/subject.hpp"

namespace brdftab {

struct PlotOptions {
  /// Degrees; none: those that suit the kind of picture.
  std::optional<std::vector<double>> theta_i;
  /// None: unpolarised, or what a table has instead.
  std::optional<Polarization> polarization;
  /// Of a material with bands; none: the first band.
  std::optional<double> wavelength_nm;
  /// One channel, drawn as points on curves in the plane of incidence.
  std::optional<Measurement> data;
};

/// The device's engine, built when a picture first needs it.
using LazyEngine = std::function<const Engine&()>;

using Plot = std::string (*)(std::span<const Subject> subjects, const PlotOptions& options,
                             const LazyEngine& engine);

/// f against theta_s in the plane of incidence, one curve for each theta_i, as the paper's Fig. 3; the nodes
/// of a table, and measured points, as dots.
std::string in_plane_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// The same with theta_s as the angle and log f as the radius.
std::string polar_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// f and its parts, the surface, bulk and retro lobes, in the plane of incidence.
std::string lobes_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// f over the hemisphere in direction cosines: of a table its own nodes, of a material the model.
std::string hemisphere_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// V_m against theta_s, as the paper's Fig. 2, and V(chi).
std::string shadowing_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// DHR and its lobes against theta_i for unpolarised, s- and p-polarised light.
std::string dhr_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// The ratio of f of two subjects over the hemisphere: at the nodes that tables share, and for materials
/// everywhere.
std::string compare_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);

struct PlotRow {
  const char* name;
  const char* summary;
  Plot plot;
};

inline constexpr PlotRow plot_table[] = {
    {"inplane", "f in the plane of incidence, a curve for each theta_i", in_plane_plot},
    {"polar", "the same in polar form", polar_plot},
    {"lobes", "the same for the surface, bulk and retro lobes apart", lobes_plot},
    {"hemisphere", "maps of f in direction cosines", hemisphere_plot},
    {"shadowing", "V_m against theta_s, and V(chi)", shadowing_plot},
    {"dhr", "directional-hemispherical reflectance by lobe and polarisation", dhr_plot},
    {"compare", "the ratio of f of two tables or materials", compare_plot},
};

/// Throws BadInput where data cannot be shown, or subjects are too many or too few for the kind.
std::string plot(const PlotRow& row, std::span<const Subject> subjects, const PlotOptions& options,
                 const LazyEngine& engine);

/// Of the light in a picture. Throws BadInput where a table does not have what is asked.
Polarization drawn_polarization(std::span<const Subject> subjects, const PlotOptions& options);

/// Names that tell subjects apart: the materials', with files where those are the same.
std::vector<std::string> subject_labels(std::span<const Subject> subjects);

/// `TITLE of NAME`, or TITLE where there are several.
std::string picture_title(std::span<const Subject> subjects, std::string_view title);

/// "unpolarised, 550 nm" and the like.
std::string light_text(const Subject& subject, const PlotOptions& options,
                       std::optional<Polarization> polarization);

}  // namespace brdftab

// The pictures of materials and tables. Each is the text of an SVG file.
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
  /// Angles of incidence in degrees; where there are none, the kind of picture chooses them.
  std::optional<std::vector<double>> theta_i;
  /// Where it is not set, pictures are for unpolarised light, or for the light that a table has instead.
  std::optional<Polarization> polarization;
  /// Chooses a band of a material with bands; where it is not set, the first one is drawn.
  std::optional<double> wavelength_nm;
  /// A measurement of one channel, which is drawn as points over the curves in the plane of incidence.
  std::optional<Measurement> data;
};

/// Returns the device's engine, and builds it when a picture first needs it.
using LazyEngine = std::function<const Engine&()>;

using Plot = std::string (*)(std::span<const Subject> subjects, const PlotOptions& options,
                             const LazyEngine& engine);

/// Draws f against theta_s in the plane of incidence, one curve for each theta_i, as the paper's Fig. 3. The
/// nodes of a table, or measured points, are dots.
std::string in_plane_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws the same in polar form: theta_s is the angle and log f the radius.
std::string polar_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws f, and the part of each lobe in it, in the plane of incidence.
std::string lobes_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws f over the hemisphere in direction cosines: the nodes of a table, or the model of a material.
std::string hemisphere_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws V_m against theta_s, as the paper's Fig. 2, and V(chi).
std::string shadowing_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws DHR, and the part of each lobe in it, against theta_i for unpolarised, s- and p-polarised light.
std::string dhr_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);
/// Draws the ratio of f of two subjects over the hemisphere. Two materials are compared everywhere; where a
/// table is among the two, they are compared at the nodes that both have.
std::string compare_plot(std::span<const Subject>, const PlotOptions&, const LazyEngine&);

/// A kind of picture.
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

/// Draws a picture of one kind. Throws BadInput where this kind does not take a setting, or where there are
/// too many or too few subjects for it.
std::string plot(const PlotRow& row, std::span<const Subject> subjects, const PlotOptions& options,
                 const LazyEngine& engine);

/// The polarisation of the light in a picture. Throws BadInput where a table does not have what is asked for.
Polarization drawn_polarization(std::span<const Subject> subjects, const PlotOptions& options);

/// A name for each subject: its material's, with the file added where several materials have the same name.
std::vector<std::string> subject_labels(std::span<const Subject> subjects);

/// "NAME: TITLE" for one subject, TITLE alone for several.
std::string picture_title(std::span<const Subject> subjects, std::string_view title);

/// What a subtitle says of the light: "unpolarised light, 550 nm" and the like.
std::string light_text(const Subject& subject, const PlotOptions& options,
                       std::optional<Polarization> polarization);

}  // namespace brdftab

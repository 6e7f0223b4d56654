// Names inside an OpenEXR table: what the writer and the reader agree on.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/model/axis.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// How slices (one theta_i, one phi_i) are laid out: a part each of one file, a tile each of one image, a
/// file each.
enum class ExrLayout { parts, tiles, files };
inline constexpr std::array<std::string_view, 3> exr_layout_names{"parts", "tiles", "files"};

/// Attributes of tables carry this before the name that they have in HDF5.
inline constexpr std::string_view exr_prefix = "brdf:";

/// Attributes of a slice: its angles of incidence, in degrees.
inline constexpr std::string_view exr_slice_theta_i = "brdf:slice_theta_i";
inline constexpr std::string_view exr_slice_phi_i = "brdf:slice_phi_i";

/// `Y`, or `T.550,000000nm` of the spectral layout of Fichet, Pacanowski and Wilkie (JCGT 10, 2021), whose
/// decimal mark is a comma; behind `s.` or `p.` for polarised light.
std::string exr_channel(Polarization polarization, std::optional<double> wavelength_nm);

/// Names of the slices by the angles of an axis: as many decimals as tell the nodes apart, `p` for the point
/// and `m` for minus, since dots separate layers: `ti05p5`, `pi000p0`.
std::string exr_slice_name(const Axis& theta_i, std::size_t i, const Axis& phi_i, std::size_t p);

}  // namespace brdftab

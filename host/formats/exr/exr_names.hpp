// Names inside an OpenEXR table: what the writer and the reader agree on.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "host/model/axis.hpp"
#include "host/model/polarization.hpp"

namespace brdftab {

/// A slice holds one theta_i and one phi_i. It is a part of one file, a tile of one image, or a file of its
/// own.
enum class ExrLayout { parts, tiles, files };
inline constexpr std::array<std::string_view, 3> exr_layout_names{"parts", "tiles", "files"};

/// Attributes of tables carry this before the name that they have in HDF5.
inline constexpr std::string_view exr_prefix = "brdf:";

/// These attributes of a slice are its angles of incidence, in degrees.
inline constexpr std::string_view exr_slice_theta_i = "brdf:slice_theta_i";
inline constexpr std::string_view exr_slice_phi_i = "brdf:slice_phi_i";

/// A channel is called `Y`, or `T.550,000000nm` in the spectral layout of Fichet, Pacanowski and Wilkie (JCGT
/// 10, 2021), whose decimal mark is a comma; `s.` or `p.` stands before it for polarised light.
std::string exr_channel(Polarization polarization, std::optional<double> wavelength_nm);

/// Slices are named by their angles: `ti05p5_pi000p0`. There are as many decimals as tell the nodes apart;
/// `p` stands for the point and `m` for minus, since dots separate layers.
std::string exr_slice_name(const Axis& theta_i, std::size_t i, const Axis& phi_i, std::size_t p);

}  // namespace brdftab

// The polarisation of the light that a table or an integral is for.
#pragma once

#include <array>
#include <string_view>

namespace brdftab {

enum class Polarization { unpolarized, s, p };

inline constexpr std::array<std::string_view, 3> polarization_names{"unpolarized", "s", "p"};
/// Names of the datasets and columns.
inline constexpr std::array<std::string_view, 3> brdf_names{"brdf", "brdf_s", "brdf_p"};

constexpr std::string_view brdf_name(Polarization p) { return brdf_names[static_cast<std::size_t>(p)]; }

}  // namespace brdftab

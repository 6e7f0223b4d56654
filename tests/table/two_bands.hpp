// A material of two bands, in which every lobe and each kind of shadowing takes part.
#pragma once

namespace brdftab {

inline constexpr const char* two_bands = R"(name = "two bands"
[parameters]
n_eff = 1.24
k_eff = 0.1
sigma_surface = 1.9
rho_surface = 0.45
sigma_bulk = 0.073
rho_bulk = 0.88
sigma_retro = 0.061
rho_retro = 1.9
w_a = 0.21
w_b = 0.12
gamma = 0.9
delta = 0.1
w = 2.0
n = 1.5
[[band]]
wavelength_nm = 450
[[band]]
wavelength_nm = 650
n_eff = 1.5
sigma_bulk = 0.2
)";

}  // namespace brdftab

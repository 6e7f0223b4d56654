#include "host/formats/exr/exr_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "host/base/numbers.hpp"

namespace brdftab {
namespace {

// Counts the decimals that give every node back.
int decimals(const Axis& axis) {
  int most = 0;
  for (const double angle : axis.nodes())
    while (most < 300 && parse_number(fmt::format("{:.{}f}", angle, most)) != angle) ++most;
  return most;
}

std::string angle_name(std::string_view tag, const Axis& axis, std::size_t k, int whole_digits) {
  const int fraction = decimals(axis);
  std::string digits = fmt::format("{:0{}.{}f}", std::abs(axis[k]),
                                   whole_digits + (fraction > 0 ? fraction + 1 : 0), fraction);
  std::replace(digits.begin(), digits.end(), '.', 'p');
  return fmt::format("{}{}{}", tag, axis[k] < 0 ? "m" : "", digits);
}

}  // namespace

std::string exr_channel(Polarization polarization, std::optional<double> wavelength_nm) {
  std::string name = "Y";
  if (wavelength_nm) {
    name = fmt::format("T.{:.6f}nm", *wavelength_nm);
    std::replace(name.begin() + 2, name.end(), '.', ',');
  }
  if (polarization == Polarization::unpolarized) return name;
  return fmt::format("{}.{}", polarization_names[static_cast<std::size_t>(polarization)], name);
}

std::string exr_slice_name(const Axis& theta_i, std::size_t i, const Axis& phi_i, std::size_t p) {
  return angle_name("ti", theta_i, i, 2) + "_" + angle_name("pi", phi_i, p, 3);
}

}  // namespace brdftab

#include "host/merl_file.hpp"

#include <array>
#include <bit>
#include <cstdint>

#include "host/error.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little);

using Dimensions = std::array<std::int32_t, 3>;
constexpr Dimensions dimensions{MerlFile::cells_h, MerlFile::cells_d, MerlFile::cells_phi};

}  // namespace

double MerlFile::scale(int channel) {
  constexpr std::array<double, 3> scales{1. / 1500, 1.15 / 1500, 1.66 / 1500};
  return scales[static_cast<std::size_t>(channel)];
}

MerlFile MerlFile::read(std::istream& in, const std::string& source) {
  Dimensions found{};
  in.read(reinterpret_cast<char*>(found.data()), sizeof(found));
  if (!in || found != dimensions) throw BadInput("{}: is no MERL file: it must begin with the dimensions 90, 90, 180", source);
  MerlFile file;
  in.read(reinterpret_cast<char*>(file.values.data()), static_cast<std::streamsize>(file.values.size() * sizeof(double)));
  if (!in) throw BadInput("{}: has fewer than the {} values of a MERL file", source, file.values.size());
  return file;
}

std::string MerlFile::bytes() const {
  std::string result(reinterpret_cast<const char*>(dimensions.data()), sizeof(dimensions));
  return result.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double));
}

}  // namespace brdftab

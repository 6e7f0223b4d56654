// A tensor file holds named arrays in binary, as Mitsuba 3, pbrt-v4 and powitacq read and write them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace brdftab {

/// A file begins with these bytes: the format's name with the zero at its end, then version 1.0.
inline constexpr std::string_view tensor_file_magic{"tensor_file\0\1\0", 14};

/// An array in C order has bytes or float32; the other list is empty.
struct Tensor {
  std::vector<std::uint64_t> shape;
  std::vector<std::uint8_t> bytes;
  std::vector<float> floats;

  static Tensor of_text(std::string_view text);
  static Tensor of_floats(std::vector<std::uint64_t> shape, std::vector<float> values);
};

using TensorFields = std::map<std::string, Tensor>;

/// Throws FileError.
void write_tensor_file(const std::filesystem::path& file, const TensorFields& fields);

/// Fields of other types than bytes and float32 are left out. Throws FileError where the file cannot be read
/// or is not whole, and BadInput `FILE: field NAME: ...` where it is not such a file.
TensorFields read_tensor_file(const std::filesystem::path& file);

}  // namespace brdftab

#include "host/formats/json/json_file.hpp"

#include <cstdint>

namespace brdftab {
namespace {

constexpr std::size_t most_samples = 1'000'000;

// This is Fowler, Noll and Vo's hash FNV-1a of 64 bits.
std::uint64_t hash_of(std::string_view text, std::uint64_t hash) {
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace

void check_json_samples(std::string_view format, std::size_t samples) {
  if (samples > most_samples)
    throw BadInput(
        "{} samples are more than the {} that {}, being text, is written with: coarser axes, or `wavelength`",
        samples, most_samples, format);
}

std::string uuid_of(std::string_view text) {
  constexpr std::uint64_t offset = 0xcbf29ce484222325u;
  const std::uint64_t first = hash_of(text, offset), second = hash_of(text, first);
  return fmt::format("{:08x}-{:04x}-8{:03x}-{:04x}-{:012x}", first >> 32, first >> 16 & 0xffff, first & 0xfff,
                     (second >> 48 & 0x3fff) | 0x8000, second & 0xffffffffffffu);
}

std::string timestamp(const ExportModel& source) {
  return source.history().substr(0, source.history().find(' '));
}

std::string json_text(const nlohmann::ordered_json& value) {
  return value.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace brdftab

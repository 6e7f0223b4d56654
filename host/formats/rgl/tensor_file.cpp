#include "host/formats/rgl/tensor_file.hpp"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <system_error>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

static_assert(std::endian::native == std::endian::little, "the file is little-endian");

enum class TensorType : std::uint8_t { bytes = 1, float32 = 10 };

constexpr std::uint64_t alignment = 8;
// One field has at most so many, so that products do not overflow.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 40;

std::uint64_t aligned(std::uint64_t offset) { return (offset + alignment - 1) / alignment * alignment; }

std::string last_error() { return std::generic_category().message(errno); }

class HeaderWriter {
 public:
  template <class Value>
  void put(Value value) {
    text_.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void put_text(std::string_view text) { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

class HeaderReader {
 public:
  HeaderReader(std::ifstream& in, const std::string& name, std::uint64_t size)
      : in_(in), name_(name), size_(size) {}

  template <class Value>
  Value take() {
    Value value;
    take_bytes(std::as_writable_bytes(std::span(&value, 1)));
    return value;
  }
  std::string take_text(std::size_t length) {
    std::string text(length, '\0');
    take_bytes(std::as_writable_bytes(std::span(text)));
    return text;
  }

 private:
  void take_bytes(std::span<std::byte> bytes) {
    if (!in_.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size())))
      throw FileError("{}: ends within its header, after {} bytes", name_, size_);
  }

  std::ifstream& in_;
  const std::string& name_;
  std::uint64_t size_;
};

std::span<const std::byte> data(const Tensor& tensor) {
  return tensor.floats.empty() ? std::as_bytes(std::span(tensor.bytes))
                               : std::as_bytes(std::span(tensor.floats));
}

std::uint64_t product(const std::vector<std::uint64_t>& shape) {
  std::uint64_t count = 1;
  for (const std::uint64_t extent : shape) {
    if (extent > most_bytes / std::max<std::uint64_t>(count, 1)) return most_bytes + 1;
    count *= extent;
  }
  return count;
}

}  // namespace

Tensor Tensor::of_text(std::string_view text) { return {{text.size()}, {text.begin(), text.end()}, {}}; }

Tensor Tensor::of_floats(std::vector<std::uint64_t> shape, std::vector<float> values) {
  return {std::move(shape), {}, std::move(values)};
}

void write_tensor_file(const std::filesystem::path& file, const TensorFields& fields) {
  std::uint64_t offset = tensor_file_magic.size() + sizeof(std::uint32_t);
  for (const auto& [name, tensor] : fields) offset += 2 + name.size() + 2 + 1 + 8 + 8 * tensor.shape.size();
  HeaderWriter header;
  header.put_text(tensor_file_magic);
  header.put(static_cast<std::uint32_t>(fields.size()));
  for (const auto& [name, tensor] : fields) {
    offset = aligned(offset);
    header.put(static_cast<std::uint16_t>(name.size()));
    header.put_text(name);
    header.put(static_cast<std::uint16_t>(tensor.shape.size()));
    header.put(tensor.floats.empty() ? TensorType::bytes : TensorType::float32);
    header.put(offset);
    for (const std::uint64_t extent : tensor.shape) header.put(extent);
    offset += data(tensor).size();
  }
  std::ofstream out(file, std::ios::binary);
  out << header.text();
  std::uint64_t written = header.text().size();
  for (const auto& [name, tensor] : fields) {
    const auto bytes = data(tensor);
    out.write("\0\0\0\0\0\0\0", static_cast<std::streamsize>(aligned(written) - written));
    out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    written = aligned(written) + bytes.size();
  }
  if (!out.flush()) throw FileError("{}: cannot be written: {}", file.string(), last_error());
}

TensorFields read_tensor_file(const std::filesystem::path& file) {
  const std::string name = file.string();
  std::ifstream in(file, std::ios::binary);
  if (!in) throw FileError("{}: cannot be read: {}", name, last_error());
  std::error_code error;
  const std::uint64_t size = std::filesystem::file_size(file, error);
  HeaderReader header(in, name, size);
  if (header.take_text(tensor_file_magic.size()) != tensor_file_magic)
    throw BadInput("{}: is no tensor file of version 1.0: its first bytes differ", name);

  struct Field {
    std::string name;
    TensorType type;
    std::uint64_t offset;
    std::vector<std::uint64_t> shape;
  };
  std::vector<Field> list;
  const auto count = header.take<std::uint32_t>();
  for (std::uint32_t k = 0; k < count; ++k) {
    Field field;
    field.name = header.take_text(header.take<std::uint16_t>());
    const auto dimensions = header.take<std::uint16_t>();
    field.type = header.take<TensorType>();
    field.offset = header.take<std::uint64_t>();
    for (std::uint16_t d = 0; d < dimensions; ++d) field.shape.push_back(header.take<std::uint64_t>());
    list.push_back(std::move(field));
  }

  TensorFields fields;
  for (auto& field : list) {
    if (field.type != TensorType::bytes && field.type != TensorType::float32) continue;
    const std::uint64_t values = product(field.shape);
    const std::uint64_t bytes = values * (field.type == TensorType::float32 ? sizeof(float) : 1);
    if (values > most_bytes || field.offset > size || bytes > size - field.offset)
      throw FileError("{}: field {}: ends at byte {}, and the file has {}", name, field.name,
                      values > most_bytes ? "more than 2^40" : std::to_string(field.offset + bytes), size);
    Tensor tensor{std::move(field.shape), {}, {}};
    in.seekg(static_cast<std::streamoff>(field.offset));
    const auto read = [&](auto& into) {
      into.resize(values);
      in.read(reinterpret_cast<char*>(into.data()), static_cast<std::streamsize>(bytes));
    };
    field.type == TensorType::float32 ? read(tensor.floats) : read(tensor.bytes);
    if (!in) throw FileError("{}: field {}: cannot be read: {}", name, field.name, last_error());
    fields.emplace(std::move(field.name), std::move(tensor));
  }
  return fields;
}

}  // namespace brdftab

// HDF5 identifiers that close themselves, and calls that throw.
#pragma once

#include <hdf5.h>

#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace brdftab {

/// It owns an identifier of any kind.
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  /// Throws FileError with HDF5's own innermost cause if `id` says that `what` failed.
  Hdf5Handle(hid_t id, std::string_view what);
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }
  ~Hdf5Handle() { close_quietly(); }

  operator hid_t() const { return id_; }
  /// Closes now, so that a failure to write can still be told. Throws FileError.
  void close(std::string_view what);

 private:
  void close_quietly() noexcept;
  hid_t id_ = H5I_INVALID_HID;
};

/// Throws FileError if an HDF5 call failed; `what` says what was attempted.
void hdf5_check(herr_t status, std::string_view what);

/// HDF5 prints its stack of errors by itself. While this object lives it does not, in the thread that made
/// the object: each function that calls HDF5 for others holds one.
class Hdf5Silence {
 public:
  Hdf5Silence();
  Hdf5Silence(const Hdf5Silence&) = delete;
  Hdf5Silence& operator=(const Hdf5Silence&) = delete;
  ~Hdf5Silence();

 private:
  H5E_auto2_t printer_ = nullptr;
  void* data_ = nullptr;
};

/// Writes one variable-length UTF-8 string, of any length, or numbers.
void write_attribute(hid_t object, const std::string& name, std::string_view text);
void write_attribute(hid_t object, const std::string& name, double value);
void write_attribute(hid_t object, const std::string& name, std::span<const double> values);

/// Says whether an open object has an attribute that is one string, of variable length or, as in older
/// tables, of fixed length.
bool has_text_attribute(hid_t object, const std::string& name);
/// Throws FileError where it has none.
std::string read_text_attribute(hid_t object, const std::string& name);

}  // namespace brdftab

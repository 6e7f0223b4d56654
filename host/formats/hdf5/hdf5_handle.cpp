#include "host/formats/hdf5/hdf5_handle.hpp"

#include <algorithm>
#include <cstdlib>
#include <system_error>

#include "host/base/error.hpp"

namespace brdftab {
namespace {

// The deepest entry of HDF5's error stack tells where the error started.
std::string innermost_cause() {
  std::string cause;
  H5Ewalk2(
      H5E_DEFAULT, H5E_WALK_UPWARD,
      [](unsigned, const H5E_error2_t* entry, void* text) -> herr_t {
        auto& deepest = *static_cast<std::string*>(text);
        if (deepest.empty() && entry->desc) deepest = entry->desc;
        return 0;
      },
      &cause);
  // The file driver tells of errno over several lines.
  if (const auto at = cause.find("errno = "); at != std::string::npos)
    return std::generic_category().message(std::atoi(cause.c_str() + at + 8));
  return cause.empty() ? "HDF5 gives no cause" : cause.substr(0, cause.find('\n'));
}

}  // namespace

void hdf5_check(herr_t status, std::string_view what) {
  if (status < 0) throw FileError("{}: {}", what, innermost_cause());
}

Hdf5Silence::Hdf5Silence() {
  H5Eget_auto2(H5E_DEFAULT, &printer_, &data_);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Hdf5Silence::~Hdf5Silence() { H5Eset_auto2(H5E_DEFAULT, printer_, data_); }

Hdf5Handle::Hdf5Handle(hid_t id, std::string_view what) : id_(id) {
  if (id < 0) throw FileError("{}: {}", what, innermost_cause());
}

void Hdf5Handle::close_quietly() noexcept {
  if (id_ < 0) return;
  const Hdf5Silence silence;
  H5Idec_ref(std::exchange(id_, H5I_INVALID_HID));
}

void Hdf5Handle::close(std::string_view what) {
  if (id_ < 0) return;
  const int status = H5Idec_ref(std::exchange(id_, H5I_INVALID_HID));
  hdf5_check(status < 0 ? -1 : 0, what);
}

void write_attribute(hid_t object, const std::string& name, std::string_view text) {
  // The string has variable length, since h5py gives such a one as str, and one of fixed length as bytes.
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), "string type");
  hdf5_check(H5Tset_size(type, H5T_VARIABLE), "string size");
  hdf5_check(H5Tset_cset(type, H5T_CSET_UTF8), "string encoding");
  const Hdf5Handle space(H5Screate(H5S_SCALAR), "attribute space");
  const Hdf5Handle attribute(H5Acreate2(object, name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT),
                             "attribute " + name);
  const std::string terminated(text);
  const char* const start = terminated.c_str();
  hdf5_check(H5Awrite(attribute, type, &start), "attribute " + name);
}

void write_attribute(hid_t object, const std::string& name, double value) {
  const Hdf5Handle space(H5Screate(H5S_SCALAR), "attribute space");
  const Hdf5Handle attribute(
      H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), "attribute " + name);
  hdf5_check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, &value), "attribute " + name);
}

void write_attribute(hid_t object, const std::string& name, std::span<const double> values) {
  const hsize_t count = values.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr), "attribute space");
  const Hdf5Handle attribute(
      H5Acreate2(object, name.c_str(), H5T_IEEE_F64LE, space, H5P_DEFAULT, H5P_DEFAULT), "attribute " + name);
  hdf5_check(H5Awrite(attribute, H5T_NATIVE_DOUBLE, values.data()), "attribute " + name);
}

bool has_text_attribute(hid_t object, const std::string& name) {
  if (H5Aexists(object, name.c_str()) <= 0) return false;
  const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "attribute " + name);
  const Hdf5Handle type(H5Aget_type(attribute), "attribute " + name);
  const Hdf5Handle space(H5Aget_space(attribute), "attribute " + name);
  return H5Tget_class(type) == H5T_STRING && H5Sget_simple_extent_npoints(space) == 1;
}

std::string read_text_attribute(hid_t object, const std::string& name) {
  if (!has_text_attribute(object, name)) throw FileError("attribute {} is not one string", name);
  const Hdf5Handle attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), "attribute " + name);
  const Hdf5Handle type(H5Aget_type(attribute), "attribute " + name);
  if (H5Tis_variable_str(type) > 0) {
    char* start = nullptr;  // HDF5 gives none for an empty string
    hdf5_check(H5Aread(attribute, type, &start), "attribute " + name);
    std::string text(start ? start : "");
    H5free_memory(start);
    return text;
  }
  std::string text(H5Tget_size(type), '\0');
  hdf5_check(H5Aread(attribute, type, text.data()), "attribute " + name);
  text.resize(std::min(text.find('\0'), text.size()));
  return text;
}

}  // namespace brdftab
